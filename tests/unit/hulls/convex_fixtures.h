#pragma once

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "common/cast/case_random.h"
#include "common/generate/parts.h"
#include "common/hulls/convex_shape.h"
#include "tests/unit/cpu/caster_fixtures.h"

namespace twintrace::test {

/// A mesh of one triangle.
inline Shape triangleShape(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  auto parts = std::make_shared<Parts>();
  parts->mesh.positions = {a, b, c};
  parts->mesh.triangles = {{0, 1, 2}};
  MeshShape mesh;
  mesh.parts = parts;
  return mesh;
}

/// The first `count` primitives.
inline std::vector<std::uint32_t> firstPrimitives(std::size_t count) {
  std::vector<std::uint32_t> primitives(count);
  std::iota(primitives.begin(), primitives.end(), 0u);
  return primitives;
}

inline std::vector<std::uint32_t> allPrimitives(const FlatScene& scene) {
  return firstPrimitives(static_cast<std::size_t>(scene.index.boundedCount()));
}

/// Unit vectors: axes, diagonals and random ones.
inline std::vector<glm::dvec3> testDirections() {
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < 27; ++i) {
    const glm::dvec3 n(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    if (length > 0.0) directions.push_back(n / length);
  }
  CaseRandom random(1);
  for (int i = 0; i < 100; ++i) directions.push_back(random.direction());
  return directions;
}

/// Spheres, boxes, turned boxes and triangles, one after the other.
inline std::vector<Shape> mixedShapes(int count, std::uint64_t seed, const glm::vec3& offset = {},
                                      float scale = 1.0f) {
  CaseRandom random(seed);
  const auto point = [&] { return glm::vec3(random.inCube(1.0)) * scale + offset; };
  std::vector<Shape> shapes;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 center = point();
    const glm::dvec3 size = (random.inCube(0.4) + glm::dvec3(0.5)) * double(scale);
    if (i % 4 == 0) shapes.emplace_back(SphereShape{center, float(size.x)});
    if (i % 4 == 1) shapes.emplace_back(BoxShape{center, size, {}});
    if (i % 4 == 2) shapes.emplace_back(BoxShape{center, size, glm::vec3(random.inCube(180.0))});
    if (i % 4 == 3) shapes.push_back(triangleShape(center, point(), point()));
  }
  return shapes;
}

}  // namespace twintrace::test
