#include <cmath>
#include <glm/geometric.hpp>

#include "common/nff/cone_mesh.h"
#include "tests/catch.h"

using namespace twintrace;

namespace {

const glm::dvec3 kBase(1.0, -2.0, 0.5);
const glm::dvec3 kApex(2.0, 1.0, 3.0);

/// Distance from the axis.
double distanceFromAxis(const glm::dvec3& p) {
  return glm::length(glm::cross(p - kBase, glm::normalize(kApex - kBase)));
}

glm::dvec3 middle(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  return (glm::dvec3(mesh.positions[a]) + glm::dvec3(mesh.positions[b])) * 0.5;
}

}  // namespace

TEST_CASE("addCone gives a cylinder 64 sides on its circle and no caps", "[nff]") {
  Mesh mesh;
  addCone(mesh, kBase, 0.75, kApex, 0.75);
  CHECK(mesh.triangles.size() == 128);
  for (const glm::vec3& p : mesh.positions) CHECK(distanceFromAxis(p) == Approx(0.75));
  // A cap would have triangles at a right angle to the sides.
  for (const Corners& c : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[c[0]]), b(mesh.positions[c[1]]), d(mesh.positions[c[2]]);
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, d - a));
    CHECK(std::abs(glm::dot(normal, glm::normalize(kApex - kBase))) < 1e-5);
    CHECK(glm::dot(normal, glm::dvec3(mesh.normals[c[0]])) > 0.99);
  }
}

TEST_CASE("coneChordError is how far the middle of a side lies inside", "[nff]") {
  Mesh mesh;
  addCone(mesh, kBase, 0.75, kApex, 0.75);
  double largest = 0.0;
  for (const Corners& c : mesh.triangles) {
    const double inside = 0.75 - distanceFromAxis(middle(mesh, c[0], c[1]));
    largest = std::max(largest, inside);
  }
  CHECK(largest == Approx(coneChordError(0.75)).epsilon(1e-3));
  CHECK(coneChordError(0.75) == Approx(0.000903).epsilon(1e-3));
}

TEST_CASE("addCone closes a cone with an apex by 64 triangles with normals off its side", "[nff]") {
  Mesh mesh;
  addCone(mesh, {0, 0, 0}, 1.0, {0, 0, 2}, 0.0);
  CHECK(mesh.triangles.size() == 64);
  for (const glm::vec3& n : mesh.normals) {
    CHECK(n.z == Approx(1.0 / std::sqrt(5.0)));
    CHECK(glm::length(glm::dvec3(n)) == Approx(1.0));
  }
}
