#include <cmath>
#include <glm/geometric.hpp>

#include "common/mesh/load_mesh.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

const float kHalf = std::sqrt(0.5f);

/// Two squares at a right angle along the z axis, one up, one to +x.
Mesh corner() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 0, 1}};
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}};
  return mesh;
}

void checkClose(const glm::vec3& a, const glm::vec3& b) {
  INFO(a.x << " " << a.y << " " << a.z);
  CHECK(glm::length(a - b) < 1e-6f);
}

TEST_CASE("addNormals gives a vertex the mean of the faces around it", "[mesh]") {
  Mesh mesh = corner();
  addNormals(mesh);
  REQUIRE(mesh.normals.size() == 6);
  for (const std::size_t edge : {0, 1}) checkClose(mesh.normals[edge], {kHalf, kHalf, 0});
  for (const std::size_t up : {2, 3}) checkClose(mesh.normals[up], {1, 0, 0});
  for (const std::size_t flat : {4, 5}) checkClose(mesh.normals[flat], {0, 1, 0});
}

TEST_CASE("addNormals weights faces by their areas", "[mesh]") {
  Mesh mesh = corner();
  mesh.positions[2].y = mesh.positions[3].y = 3.0f;
  addNormals(mesh);
  checkClose(mesh.normals[0], glm::normalize(glm::vec3(3, 1, 0)));
}

TEST_CASE("addNormals joins vertices in the same place, whatever else they have", "[mesh]") {
  Mesh mesh = corner();
  // The second square gets vertices of its own along the edge; -0 is the same place as 0.
  mesh.positions.insert(mesh.positions.end(), {{-0.0f, 0, 0}, {0, -0.0f, 1}});
  mesh.triangles[2] = {6, 7, 5};
  mesh.triangles[3] = {6, 5, 4};
  addNormals(mesh);
  for (const std::size_t edge : {0, 1, 6, 7}) checkClose(mesh.normals[edge], {kHalf, kHalf, 0});
}

TEST_CASE("addNormals gives +y to vertices without a face, or with faces back to back", "[mesh]") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {5, 5, 5}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  addNormals(mesh);
  CHECK(mesh.normals == std::vector<glm::vec3>(4, {0, 1, 0}));
}

TEST_CASE("addNormals copes with the largest coordinates", "[mesh]") {
  Mesh mesh = corner();
  for (glm::vec3& p : mesh.positions) p *= 1e18f;
  addNormals(mesh);
  checkClose(mesh.normals[0], {kHalf, kHalf, 0});
}

}  // namespace
}  // namespace twintrace
