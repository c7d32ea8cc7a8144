#include "common/generate/recipes.h"

namespace twintrace {
namespace {

constexpr std::array<glm::dvec3, 4> kCorners = {
    {{1.0, 1.0, 1.0}, {1.0, -1.0, -1.0}, {-1.0, 1.0, -1.0}, {-1.0, -1.0, 1.0}}};

/// Counterclockwise seen from outside.
constexpr std::array<Corners, 4> kFaces = {{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};

void addTetrahedron(Mesh& mesh, const glm::dvec3& center, double size) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::dvec3& corner : kCorners) mesh.positions.emplace_back(center + corner * size);
  for (const Corners& face : kFaces) {
    mesh.triangles.push_back({first + face[0], first + face[1], first + face[2]});
  }
}

void subdivide(Mesh& mesh, const glm::dvec3& center, double size, int levels) {
  if (levels == 1) return addTetrahedron(mesh, center, size);
  for (const glm::dvec3& corner : kCorners) {
    subdivide(mesh, center + corner * (size / 2.0), size / 2.0, levels - 1);
  }
}

}  // namespace

std::int64_t tetraCount(int levels) {
  return std::int64_t{1} << (2 * levels);
}

std::vector<Parts> makeTetra(int levels, std::uint32_t) {
  std::vector<Parts> objects(1);
  Mesh& mesh = objects[0].mesh;
  const auto count = static_cast<std::size_t>(tetraCount(levels));
  mesh.positions.reserve(count);
  mesh.triangles.reserve(count);
  subdivide(mesh, glm::dvec3(0.0), 1.0, levels);
  return objects;
}

}  // namespace twintrace
