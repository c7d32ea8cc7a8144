#include "common/hulls/tightness.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/hulls/polytope.h"

namespace twintrace {
namespace {

constexpr int kDirections = 512;  // over half the sphere
constexpr int kMostNodes = 64;    // measured; of more, evenly spaced ones stand for all

/// Evenly spread unit vectors: a spiral of golden angles.
std::vector<glm::dvec3> directions() {
  std::vector<glm::dvec3> result;
  for (int i = 0; i < kDirections; ++i) {
    const double z = (i + 0.5) / kDirections;
    const double across = std::sqrt(1.0 - z * z);
    const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    result.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
  }
  return result;
}

/// Of a sphere, a triangle seen from both sides, or a box of any angles: exact.
PolytopeMeasure measureOf(const ConvexShape& shape) {
  if (shape.count == 1) {
    const double area = 4.0 * std::numbers::pi * shape.radius * shape.radius;
    return {area, area * shape.radius / 3.0};
  }
  const glm::dvec3 u = shape.points[1] - shape.points[0];
  const glm::dvec3 v = shape.points[2] - shape.points[0];
  if (shape.count == 3) return {glm::length(glm::cross(u, v)), 0.0};
  const glm::dvec3 w = shape.points[4] - shape.points[0];
  const double area =
      glm::length(glm::cross(u, v)) + glm::length(glm::cross(v, w)) + glm::length(glm::cross(w, u));
  return {2.0 * area, std::fabs(glm::dot(glm::cross(u, v), w))};
}

PolytopeMeasure convexHullOf(const ShapeRange& shapes) {
  const ConvexShape first = *shapes.begin();
  if (shapes.size() == 1) return measureOf(first);
  std::vector<HalfSpace> spaces;
  for (const glm::dvec3& n : directions()) {
    double most = first.support(n);
    double least = first.support(-n);
    for (const ConvexShape& shape : shapes) {
      most = std::max(most, shape.support(n));
      least = std::max(least, shape.support(-n));
    }
    spaces.push_back({n, most});
    spaces.push_back({-n, least});
  }
  return measurePolytope(spaces);
}

}  // namespace

Tightness tightnessOf(const FlatScene& scene, const HullStructure& hulls) {
  const bool flat = hulls.arrangement == HullArrangement::flat;
  PolytopeMeasure outer;
  PolytopeMeasure inner;
  const int count = flat ? hulls.nodeCount : std::min(hulls.nodeCount, 1);
  for (int i = 0; i < std::min(count, kMostNodes); ++i) {
    const int node = static_cast<int>(std::int64_t{i} * count / std::min(count, kMostNodes));
    const std::vector<std::uint32_t> primitives = hulls.primitivesBelow(node);
    const PolytopeMeasure contents = convexHullOf(ShapeRange(scene, primitives));
    inner.area += contents.area;
    inner.content += contents.content;
    outer.area += hulls.volume.area(hulls.volume, hulls.record(node));
    outer.content += hulls.volume.content(hulls.volume, hulls.record(node));
  }
  const auto ratio = [](double a, double b) { return b > 0.0 ? a / b : 0.0; };
  return {ratio(outer.area, inner.area), ratio(outer.content, inner.content)};
}

}  // namespace twintrace
