#include "common/nff/cone_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace twintrace {
namespace {

/// A unit vector at a right angle to a unit vector.
glm::dvec3 acrossFrom(const glm::dvec3& axis) {
  const glm::dvec3 size = glm::abs(axis);
  const bool xIsLeast = size.x <= size.y && size.x <= size.z;
  const glm::dvec3 other(xIsLeast ? 1.0 : 0.0, xIsLeast ? 0.0 : 1.0, 0.0);
  return glm::normalize(glm::cross(axis, other));
}

}  // namespace

void addCone(Mesh& mesh, const glm::dvec3& base, double baseRadius, const glm::dvec3& apex,
             double apexRadius) {
  const double height = glm::length(apex - base);
  const glm::dvec3 axis = (apex - base) / height;
  const glm::dvec3 u = acrossFrom(axis);
  const glm::dvec3 v = glm::cross(axis, u);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < kConeSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kConeSides;
    const glm::dvec3 out = u * std::cos(angle) + v * std::sin(angle);
    const glm::vec3 normal(glm::normalize(out * height + axis * (baseRadius - apexRadius)));
    mesh.positions.emplace_back(base + out * baseRadius);
    mesh.positions.emplace_back(apex + out * apexRadius);
    mesh.normals.insert(mesh.normals.end(), 2, normal);
  }
  for (std::uint32_t i = 0; i < kConeSides; ++i) {
    const std::uint32_t here = first + 2 * i;
    const std::uint32_t next = first + 2 * ((i + 1) % kConeSides);
    if (baseRadius > 0.0) mesh.triangles.push_back({here, next, here + 1});
    if (apexRadius > 0.0) mesh.triangles.push_back({next, next + 1, here + 1});
  }
}

double coneChordError(double radius) {
  return radius * (1.0 - std::cos(std::numbers::pi / kConeSides));
}

}  // namespace twintrace
