#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/mesh/triangulate.h"
#include "tests/catch.h"

using namespace twintrace;

namespace {

using Polygon = std::vector<glm::vec3>;

double signedArea(const Polygon& p, const Corners& c) {
  const glm::dvec3 a(p[c[0]]), b(p[c[1]]), d(p[c[2]]);
  return glm::cross(b - a, d - a).z * 0.5;
}

struct Result {
  Cut cut;
  std::vector<Corners> triangles;
  double area = 0.0;       ///< of the triangles, counterclockwise ones above 0
  double leastArea = 1.0;  ///< of one of them
};

/// Cuts a polygon of the plane z = 0.
Result cutPolygon(const Polygon& polygon) {
  Result result{};
  result.cut = PolygonCutter().cut(polygon, 0, result.triangles);
  for (const Corners& corners : result.triangles) {
    const double area = signedArea(polygon, corners);
    result.area += area;
    result.leastArea = std::min(result.leastArea, area);
  }
  return result;
}

/// A star with as many teeth, going in and out by turns: 2 * teeth corners.
Polygon star(int teeth) {
  Polygon polygon;
  for (int i = 0; i < 2 * teeth; ++i) {
    const double angle = std::numbers::pi * i / teeth, radius = i % 2 == 0 ? 1.0 : 0.5;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return polygon;
}

}  // namespace

TEST_CASE("PolygonCutter covers an L without its notch", "[mesh]") {
  const Result l = cutPolygon({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
  CHECK(l.cut == Cut::clean);
  CHECK(l.triangles.size() == 4);
  CHECK(l.area == Approx(3.0));
  CHECK(l.leastArea > 0.0);
}

TEST_CASE("PolygonCutter keeps the order of corners of a polygon that goes round to the right",
          "[mesh]") {
  const Result l = cutPolygon({{0, 2, 0}, {1, 2, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}, {0, 0, 0}});
  CHECK(l.cut == Cut::clean);
  CHECK(l.area == Approx(-3.0));
}

TEST_CASE("PolygonCutter covers a star of 144 corners", "[mesh]") {
  const Polygon polygon = star(72);
  const Result result = cutPolygon(polygon);
  CHECK(result.cut == Cut::clean);
  CHECK(result.triangles.size() == 142);
  CHECK(result.area == Approx(areaVector(polygon).z).epsilon(1e-12));
  CHECK(result.leastArea > 0.0);
}

TEST_CASE("PolygonCutter keeps corners in line as corners of triangles", "[mesh]") {
  const Polygon polygon = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}};
  const Result result = cutPolygon(polygon);
  CHECK(result.cut == Cut::clean);
  CHECK(result.area == Approx(6.0));
  CHECK(result.leastArea > 0.0);
  std::vector<bool> used(polygon.size(), false);
  for (const Corners& corners : result.triangles) {
    for (const std::uint32_t corner : corners) used[corner] = true;
  }
  CHECK(used == std::vector<bool>(polygon.size(), true));
}

TEST_CASE("PolygonCutter covers a square with a hole that is cut open", "[mesh]") {
  const Result frame = cutPolygon({{0, 0, 0},
                                   {3, 0, 0},
                                   {3, 3, 0},
                                   {0, 3, 0},
                                   {0, 0, 0},
                                   {1, 1, 0},
                                   {1, 2, 0},
                                   {2, 2, 0},
                                   {2, 1, 0},
                                   {1, 1, 0}});
  CHECK(frame.area == Approx(8.0));
  CHECK(frame.leastArea > 0.0);
}

TEST_CASE("PolygonCutter finds no triangle where there is no area", "[mesh]") {
  CHECK(cutPolygon({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}).cut == Cut::nothing);
  CHECK(cutPolygon({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).cut == Cut::nothing);
  CHECK(cutPolygon({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}}).triangles.empty());
}

TEST_CASE("PolygonCutter comes to an end where a polygon that crosses itself has no ear",
          "[mesh]") {
  const Result spikes = cutPolygon({{2, 5, 0}, {6, 6, 0}, {6, 7, 0}, {6, 8, 0}, {2, 2, 0}});
  CHECK(spikes.cut == Cut::crossed);
  CHECK_FALSE(spikes.triangles.empty());
}

TEST_CASE("PolygonCutter comes through a polygon of 16384 corners, half of them concave",
          "[mesh]") {
  const Polygon polygon = star(8192);
  const Result result = cutPolygon(polygon);
  CHECK(result.cut == Cut::clean);
  CHECK(result.triangles.size() == 16382);
}
