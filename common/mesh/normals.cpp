#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "common/mesh/load_mesh.h"

namespace twintrace {
namespace {

bool isBefore(const glm::vec3& a, const glm::vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

/// By vertex, a number that those in the same place share: their texture coordinates may differ.
std::vector<std::uint32_t> places(const std::vector<glm::vec3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return isBefore(positions[a], positions[b]);
  });
  std::vector<std::uint32_t> place(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    place[order[i]] = same ? place[order[i - 1]] : order[i];
  }
  return place;
}

}  // namespace

void addNormals(Mesh& mesh) {
  const std::vector<std::uint32_t> place = places(mesh.positions);
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
  for (const Corners& corners : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[corners[0]]);
    const glm::dvec3 area = glm::cross(glm::dvec3(mesh.positions[corners[1]]) - a,
                                       glm::dvec3(mesh.positions[corners[2]]) - a);
    for (const std::uint32_t corner : corners) sums[place[corner]] += area;
  }
  mesh.normals.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const glm::dvec3& sum = sums[place[i]];
    const double length = glm::length(sum);
    const bool has = length > 0.0 && std::isfinite(length);
    mesh.normals[i] = has ? glm::vec3(sum / length) : glm::vec3(0.0f, 1.0f, 0.0f);
  }
}

}  // namespace twintrace
