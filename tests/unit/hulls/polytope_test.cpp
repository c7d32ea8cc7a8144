#include "common/hulls/polytope.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "tests/catch.h"

namespace twintrace {
namespace {

/// The half-spaces |n . (p - center)| <= offset for each normal.
std::vector<HalfSpace> slabs(const std::vector<glm::dvec3>& normals, double offset,
                             const glm::dvec3& center = glm::dvec3(0.0)) {
  std::vector<HalfSpace> spaces;
  for (const glm::dvec3& n : normals) {
    spaces.push_back({n, offset + glm::dot(n, center)});
    spaces.push_back({-n, offset - glm::dot(n, center)});
  }
  return spaces;
}

const std::vector<glm::dvec3> kAxes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<glm::dvec3> kDiagonals = {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

void checkMeasure(const std::vector<HalfSpace>& spaces, double area, double content) {
  const PolytopeMeasure measure = measurePolytope(spaces);
  CHECK(measure.area == Approx(area).epsilon(1e-9).margin(1e-11));
  CHECK(measure.content == Approx(content).epsilon(1e-9).margin(1e-12));
}

TEST_CASE("measurePolytope measures a cube", "[hulls]") {
  checkMeasure(slabs(kAxes, 1.0), 24.0, 8.0);
  checkMeasure(slabs(kAxes, 0.25), 1.5, 0.125);
}

TEST_CASE("measurePolytope measures an octahedron", "[hulls]") {
  // |x| + |y| + |z| <= 1: eight equilateral triangles of side sqrt(2).
  checkMeasure(slabs(kDiagonals, 1.0), 4.0 * std::sqrt(3.0), 4.0 / 3.0);
}

TEST_CASE("measurePolytope measures a tetrahedron", "[hulls]") {
  checkMeasure({{{-1, 0, 0}, 0.0}, {{0, -1, 0}, 0.0}, {{0, 0, -1}, 0.0}, {{1, 1, 1}, 1.0}},
               1.5 + std::sqrt(3.0) / 2.0, 1.0 / 6.0);
}

TEST_CASE("measurePolytope takes normals of any length", "[hulls]") {
  std::vector<HalfSpace> spaces = slabs(kDiagonals, 1.0);
  double factor = 1e-3;
  for (HalfSpace& space : spaces) {
    space.normal *= factor;
    space.offset *= factor;
    factor *= 10.0;
  }
  checkMeasure(spaces, 4.0 * std::sqrt(3.0), 4.0 / 3.0);
}

TEST_CASE("measurePolytope does not depend on the place", "[hulls]") {
  checkMeasure(slabs(kAxes, 1.0, {3, -4, 5}), 24.0, 8.0);
  const PolytopeMeasure far = measurePolytope(slabs(kDiagonals, 1.0, {1e4, 2e4, -3e4}));
  CHECK(far.area == Approx(4.0 * std::sqrt(3.0)).epsilon(1e-6));
  CHECK(far.content == Approx(4.0 / 3.0).epsilon(1e-6));
}

TEST_CASE("measurePolytope counts a plane once, and none that only touches", "[hulls]") {
  std::vector<HalfSpace> twice = slabs(kAxes, 1.0);
  const std::vector<HalfSpace> copy = twice;
  twice.insert(twice.end(), copy.begin(), copy.end());
  checkMeasure(twice, 24.0, 8.0);
  // The loosest of parallel planes don't count.
  twice[0].offset = 1.0 + 1e-15;
  twice[9].offset = 7.0;
  checkMeasure(twice, 24.0, 8.0);
  // The diagonals touch the cube's corners, or stay away.
  for (const double offset : {3.0, 100.0}) {
    std::vector<HalfSpace> touched = copy;
    const std::vector<HalfSpace> more = slabs(kDiagonals, offset);
    touched.insert(touched.end(), more.begin(), more.end());
    checkMeasure(touched, 24.0, 8.0);
  }
}

TEST_CASE("measurePolytope counts both sides of what is flat", "[hulls]") {
  std::vector<HalfSpace> flat = slabs(kAxes, 1.0);
  flat[0].offset = flat[1].offset = 0.0;
  checkMeasure(flat, 8.0, 0.0);
  // The triangle between the axes' unit points, along each diagonal of the cube.
  for (const glm::dvec3& n : kDiagonals) {
    const glm::dvec3 low = glm::min(n, glm::dvec3(0.0)), high = glm::max(n, glm::dvec3(0.0));
    std::vector<HalfSpace> triangle = {{n, 1.0}, {-n, -1.0}};
    for (int i = 0; i < 3; ++i) {
      triangle.push_back({kAxes[static_cast<std::size_t>(i)], high[i]});
      triangle.push_back({-kAxes[static_cast<std::size_t>(i)], -low[i]});
    }
    checkMeasure(triangle, std::sqrt(3.0), 0.0);
  }
}

TEST_CASE("measurePolytope finds nothing in a point or a line", "[hulls]") {
  checkMeasure(slabs(kAxes, 0.0), 0.0, 0.0);
  std::vector<HalfSpace> line = slabs(kAxes, 0.0);
  line[0].offset = line[1].offset = 1.0;
  checkMeasure(line, 0.0, 0.0);
}

}  // namespace
}  // namespace twintrace
