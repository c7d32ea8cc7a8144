#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/hulls/volumes/record.h"

namespace twintrace {
namespace {

constexpr std::size_t kFewShapes = 4096;
constexpr int kManySteps = 100;
constexpr int kFewSteps = 8;

/// The largest distance from a point to a shape's far side, and where that is.
struct Farthest {
  double distance = 0.0;
  glm::dvec3 point{0.0};
};

void extend(Farthest& farthest, const glm::dvec3& center, const ConvexShape& shape) {
  for (int i = 0; i < shape.count; ++i) {
    const glm::dvec3& p = shape.points[static_cast<std::size_t>(i)];
    const double distance = glm::length(p - center) + shape.radius;
    if (distance > farthest.distance) farthest = {distance, p};
  }
}

Farthest farthestFrom(const glm::dvec3& center, const ShapeRange& shapes) {
  Farthest farthest;
  for (const ConvexShape& shape : shapes) extend(farthest, center, shape);
  return farthest;
}

/// Moves towards the farthest point by ever smaller steps: within a percent of the smallest sphere after
/// a hundred. Badoiu and Clarkson 2003, "Smaller Core-Sets for Balls".
void fit(const HullVolume&, const ShapeRange& shapes, std::span<glm::uvec4> record) {
  Bounds bounds = Bounds::nothing();
  for (const ConvexShape& shape : shapes) bounds.add(boundsOf(shape));
  glm::dvec3 center(bounds.center());
  glm::vec3 best(center);
  double radius = farthestFrom(glm::dvec3(best), shapes).distance;
  const int steps = shapes.size() <= kFewShapes ? kManySteps : kFewSteps;
  for (int i = 1; i <= steps; ++i) {
    const Farthest farthest = farthestFrom(center, shapes);
    center += (farthest.point - center) / (i + 1.0);
    const double here = farthestFrom(glm::dvec3(glm::vec3(center)), shapes).distance;
    if (here >= radius) continue;
    best = glm::vec3(center);
    radius = here;
  }
  record[0] = recordTexel(best, roundedUp(radius));
}

double area(const HullVolume&, std::span<const glm::uvec4> record) {
  const double r = recordNumber(record[0]);
  return 4.0 * std::numbers::pi * r * r;
}

double content(const HullVolume&, std::span<const glm::uvec4> record) {
  const double r = recordNumber(record[0]);
  return 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

}  // namespace

HullVolume sphereVolume() {
  return {"sphere", 1, 1, fit, area, content};
}

}  // namespace twintrace
