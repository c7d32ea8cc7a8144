#include "common/hulls/polytope.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace twintrace {
namespace {

/// A square's corners are 4 sqrt(2) sizes away, their products with a normal off by 3 roundings:
/// 2^-48, and more where edges are cut at a flat angle.
constexpr double kRounding = 0x1p-45;

using Polygon = std::vector<glm::dvec3>;

/// A square on the half-space's plane that is larger than any face.
Polygon squareOn(const HalfSpace& space, double size) {
  const glm::dvec3 n = glm::normalize(space.normal);
  const glm::dvec3 axis = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(n, axis)) * size;
  const glm::dvec3 v = glm::normalize(glm::cross(n, u)) * size;
  const glm::dvec3 foot = n * (space.offset / glm::length(space.normal));
  return {foot - u - v, foot + u - v, foot + u + v, foot - u + v};
}

/// The part of a polygon in a half-space. Sutherland and Hodgman 1974.
/// @param slack how far off points may be by rounding, as a distance: both sides of what is flat
/// stay
Polygon clipped(const Polygon& polygon, const HalfSpace& space, double slack) {
  const double offset = space.offset + slack * glm::length(space.normal);
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3& a = polygon[i];
    const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
    const double insideA = offset - glm::dot(space.normal, a);
    const double insideB = offset - glm::dot(space.normal, b);
    if (insideA >= 0.0) result.push_back(a);
    if ((insideA >= 0.0) != (insideB >= 0.0)) {
      result.push_back(a + (b - a) * (insideA / (insideA - insideB)));
    }
  }
  return result;
}

double areaOf(const Polygon& polygon) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return 0.5 * glm::length(sum);
}

/// Whether another half-space lies in this one, with a parallel plane; of equal ones, the first
/// does.
bool isWithin(const HalfSpace& other, const HalfSpace& space) {
  return other.normal == space.normal &&
         (other.offset < space.offset || (other.offset == space.offset && &other < &space));
}

}  // namespace

PolytopeMeasure measurePolytope(std::span<const HalfSpace> spaces) {
  double size = 0.0;
  for (const HalfSpace& space : spaces) {
    size = std::max(size, std::abs(space.offset) / glm::length(space.normal));
  }
  PolytopeMeasure measure;
  for (const HalfSpace& face : spaces) {
    const auto isTighter = [&](const HalfSpace& other) { return isWithin(other, face); };
    if (std::ranges::any_of(spaces, isTighter)) continue;
    Polygon polygon = squareOn(face, 4.0 * size);
    for (const HalfSpace& other : spaces) {
      if (other.normal != face.normal) polygon = clipped(polygon, other, kRounding * size);
    }
    const double area = areaOf(polygon);
    measure.area += area;
    measure.content += area * face.offset / glm::length(face.normal) / 3.0;
  }
  return measure;
}

}  // namespace twintrace
