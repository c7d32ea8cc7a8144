#include "common/hulls/volumes/volumes.h"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/hulls/volumes/record.h"
#include "tests/catch.h"
#include "tests/unit/hulls/convex_fixtures.h"

namespace twintrace {
namespace {

using std::numbers::pi;
using test::flatSceneOf;
using test::Shape;

constexpr std::uint32_t kAll = kAxes | kCubeDiagonals | kFaceDiagonals;

HullVolume boxAndSphere() {
  return findHullStrategy("aabb+sphere")->volume;
}

using Record = std::vector<glm::uvec4>;

Record fitted(const HullVolume& volume, const FlatScene& scene) {
  Record record(static_cast<std::size_t>(volume.texels));
  const std::vector<std::uint32_t> primitives = test::allPrimitives(scene);
  volume.fit(volume, ShapeRange(scene, primitives), record);
  return record;
}

/// How far a point lies outside of a record, for each kind of hull as its shader defines it.
using Outside = std::function<double(const Record&, const glm::dvec3&)>;

double outsideSlab(double place, double low, double high) {
  return std::max(low - place, place - high);
}

double outsideAabb(const Record& record, const glm::dvec3& p) {
  const glm::dvec3 low = recordVector(record[0]), high = recordVector(record[1]);
  double outside = -1e300;
  for (int i = 0; i < 3; ++i) outside = std::max(outside, outsideSlab(p[i], low[i], high[i]));
  return outside;
}

double outsideSphere(const Record& record, const glm::dvec3& p) {
  return glm::length(p - recordVector(record[0])) - recordNumber(record[0]);
}

double outsideObb(const Record& record, const glm::dvec3& p) {
  const glm::dvec3 half = recordVector(record[4]);
  double outside = -1e300;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 axis = recordVector(record[static_cast<std::size_t>(1 + i)]);
    const double place = glm::dot(axis, p - recordVector(record[0]));
    outside = std::max(outside, outsideSlab(place, -half[i], half[i]));
  }
  return outside;
}

double outsideBoxAndSphere(const Record& record, const glm::dvec3& p) {
  return std::max(outsideAabb(record, p), outsideSphere({record[2]}, p));
}

/// The coordinates along all normals, as slabCoordinates of shaders/hulls/hull_ray.glsl has them.
std::array<double, 15> slabPlaces(const glm::dvec3& p) {
  return {p.x,
          p.y,
          p.z,
          p.x + p.y + p.z,
          p.x + p.y - p.z,
          p.x - p.y + p.z,
          -p.x + p.y + p.z,
          p.x + p.y,
          p.x - p.y,
          p.x + p.z,
          p.x - p.z,
          p.y + p.z,
          p.y - p.z,
          p.y - p.z,
          p.y - p.z};
}

double outsideKdop(const Record& record, const glm::dvec3& p) {
  const std::array<double, 15> places = slabPlaces(p);
  double outside = -1e300;
  for (std::size_t slab = 0; slab < record.size() / 2 * 3; ++slab) {
    const std::size_t at = 2 * (slab / 3);
    const int i = static_cast<int>(slab % 3);
    outside = std::max(outside, outsideSlab(places[slab], recordVector(record[at])[i],
                                            recordVector(record[at + 1])[i]));
  }
  return outside;
}

struct Kind {
  std::string name;
  HullVolume volume;
  Outside outside;
};

std::vector<Kind> allKinds() {
  return {{"aabb", aabbVolume(), outsideAabb},
          {"sphere", sphereVolume(), outsideSphere},
          {"obb", obbVolume(), outsideObb},
          {"aabb+sphere", boxAndSphere(), outsideBoxAndSphere},
          {"kdop6", kdopVolume(kAxes), outsideKdop},
          {"kdop8", kdopVolume(kCubeDiagonals), outsideKdop},
          {"kdop14", kdopVolume(kAxes | kCubeDiagonals), outsideKdop},
          {"kdop18", kdopVolume(kAxes | kFaceDiagonals), outsideKdop},
          {"kdop26", kdopVolume(kAll), outsideKdop}};
}

/// How far the farthest of many points on a scene's surfaces lies outside of its hull.
double farthestOutside(const Kind& kind, const FlatScene& scene) {
  const Record record = fitted(kind.volume, scene);
  double outside = -1e300;
  for (int primitive = 0; primitive < scene.index.boundedCount(); ++primitive) {
    const ConvexShape shape = convexShape(scene, primitive);
    for (int i = 0; i < shape.count; ++i) {
      const glm::dvec3& p = shape.points[static_cast<std::size_t>(i)];
      for (const glm::dvec3& n : test::testDirections()) {
        outside = std::max(outside, kind.outside(record, p + n * shape.radius));
      }
    }
  }
  return outside;
}

/// Rounding of the double arithmetic above, a few units of the largest coordinate.
double rounding(double largest) {
  return 32.0 * 0x1p-53 * largest;
}

double areaOf(const HullVolume& volume, const FlatScene& scene) {
  return volume.area(volume, fitted(volume, scene));
}

double contentOf(const HullVolume& volume, const FlatScene& scene) {
  return volume.content(volume, fitted(volume, scene));
}

void checkMeasure(const HullVolume& volume, const std::vector<Shape>& shapes, double area,
                  double content) {
  const auto scene = flatSceneOf(shapes);
  // Records are rounded outwards to floats.
  CHECK(areaOf(volume, *scene) == Approx(area).epsilon(1e-5));
  CHECK(contentOf(volume, *scene) == Approx(content).epsilon(1e-5).margin(1e-9));
}

const std::vector<Shape> kBall = {SphereShape{{0.25f, 0.5f, -1.0f}, 0.5f}};
const std::vector<Shape> kBrick = {BoxShape{{1, 2, 3}, {2, 4, 6}, {}}};

TEST_CASE("Hulls contain their shapes", "[hulls]") {
  for (const Kind& kind : allKinds()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const int count = 1 + static_cast<int>(seed);
      const auto scene = flatSceneOf(test::mixedShapes(count, seed));
      INFO(kind.name << ", seed " << seed);
      CHECK(farthestOutside(kind, *scene) <= rounding(8.0));
    }
  }
}

TEST_CASE("Hulls contain shapes that are far from the origin, large or small", "[hulls]") {
  for (const Kind& kind : allKinds()) {
    INFO(kind.name);
    CHECK(farthestOutside(kind, *flatSceneOf(test::mixedShapes(9, 1, {1e6f, -1e6f, 1e5f}))) <=
          rounding(4e6));
    CHECK(farthestOutside(kind, *flatSceneOf(test::mixedShapes(9, 2, {}, 1e15f))) <=
          rounding(8e15));
    CHECK(farthestOutside(kind, *flatSceneOf(test::mixedShapes(9, 3, {}, 1e-15f))) <=
          rounding(8e-15));
  }
}

TEST_CASE("Hulls contain shapes that are flat, or one point wide", "[hulls]") {
  const std::vector<std::vector<Shape>> cases = {
      {BoxShape{{1, 2, 3}, {2, 0, 2}, {}}},
      {BoxShape{{1, 2, 3}, {2, 0, 0}, {}}},
      {BoxShape{{1, 2, 3}, {2, 0, 2}, glm::vec3(30, 40, 50)}},
      {test::triangleShape({1, 0, 0}, {0, 1, 0}, {0, 0, 1})},
      {test::triangleShape({0.1f, 0.2f, 0.3f}, {0.1f, 0.7f, 0.3f}, {0.1f, 0.2f, 0.9f})},
      {test::triangleShape({0.1f, 0.2f, 0.3f}, {0.2f, 0.4f, 0.6f}, {0.3f, 0.6f, 0.9f})}};
  for (const Kind& kind : allKinds()) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      INFO(kind.name << ", case " << i);
      CHECK(farthestOutside(kind, *flatSceneOf(cases[i])) <= rounding(8.0));
    }
  }
}

TEST_CASE("An axis-aligned box has a brick's area and volume", "[hulls]") {
  checkMeasure(aabbVolume(), kBrick, 88.0, 48.0);
  checkMeasure(aabbVolume(), kBall, 6.0, 1.0);
  checkMeasure(aabbVolume(), {BoxShape{{1, 2, 3}, {2, 0, 2}, {}}}, 8.0, 0.0);
}

TEST_CASE("A sphere about a ball is the ball", "[hulls]") {
  checkMeasure(sphereVolume(), kBall, pi, pi / 6.0);
}

TEST_CASE("A sphere about a cube touches its corners", "[hulls]") {
  const double r = std::sqrt(3.0);
  checkMeasure(sphereVolume(), {BoxShape{{0, 0, 0}, {2, 2, 2}, {}}}, 4.0 * pi * r * r,
               4.0 / 3.0 * pi * r * r * r);
}

TEST_CASE("Spheres are within 2 percent of the smallest", "[hulls]") {
  const auto radiusOf = [](const std::vector<Shape>& shapes) {
    return recordNumber(fitted(sphereVolume(), *flatSceneOf(shapes))[0]);
  };
  const auto isNear = [](double radius, double smallest) {
    CHECK(radius >= smallest * (1.0 - 1e-6));
    CHECK(radius <= smallest * 1.02);
  };
  // An equilateral triangle of side 1, whose circumcenter is not the middle of its bounds.
  isNear(radiusOf({test::triangleShape({0, 0, 0}, {1, 0, 0}, {0.5f, 0.8660254f, 0})}),
         1.0 / std::sqrt(3.0));
  // Two balls: from far side to far side.
  isNear(radiusOf({SphereShape{{0, 0, 0}, 1.0f}, SphereShape{{1.5f, 1.5f, 0}, 0.25f}}),
         (std::sqrt(4.5) + 1.25) / 2.0);
  // One in another.
  isNear(radiusOf({SphereShape{{0, 0, 0}, 1.0f}, SphereShape{{0.3f, 0.3f, 0.3f}, 0.25f}}), 1.0);
  // The corners of a regular tetrahedron, but off the middle of the bounds by a fifth point inside.
  isNear(radiusOf({test::triangleShape({1, 1, 1}, {1, -1, -1}, {-1, 1, -1}),
                   test::triangleShape({1, 1, 1}, {0, 0, 0}, {-1, -1, 1})}),
         std::sqrt(3.0));
}

TEST_CASE("An oriented box about a turned brick is the brick", "[hulls]") {
  checkMeasure(obbVolume(), {BoxShape{{1, 2, 3}, {2, 4, 6}, glm::vec3(20, 40, 60)}}, 88.0, 48.0);
  checkMeasure(obbVolume(), kBrick, 88.0, 48.0);
  checkMeasure(obbVolume(), kBall, 6.0, 1.0);
}

TEST_CASE("An oriented box is never larger than the aligned one", "[hulls]") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto scene = flatSceneOf(test::mixedShapes(5, seed));
    CHECK(areaOf(obbVolume(), *scene) <= areaOf(aabbVolume(), *scene) * (1.0 + 1e-6));
  }
}

TEST_CASE("k-DOPs about a ball have the area and volume of their solids", "[hulls]") {
  const double r = 0.5;
  checkMeasure(kdopVolume(kAxes), kBall, 24.0 * r * r, 8.0 * r * r * r);
  // An octahedron and a rhombic dodecahedron around a ball.
  checkMeasure(kdopVolume(kCubeDiagonals), kBall, 12.0 * std::sqrt(3.0) * r * r,
               4.0 * std::sqrt(3.0) * r * r * r);
  checkMeasure(kdopVolume(kFaceDiagonals), kBall, 12.0 * std::sqrt(2.0) * r * r,
               4.0 * std::sqrt(2.0) * r * r * r);
}

TEST_CASE("k-DOPs about a ball get smaller with every slab", "[hulls]") {
  const auto scene = flatSceneOf(kBall);
  double before = 1e9;
  for (const std::uint32_t slabs : {kAxes, kAxes | kCubeDiagonals, kAxes | kFaceDiagonals, kAll}) {
    const double area = areaOf(kdopVolume(slabs), *scene);
    CHECK(area < before);
    CHECK(area > pi);
    // Every face touches the ball.
    CHECK(contentOf(kdopVolume(slabs), *scene) == Approx(area * 0.5 / 3.0).epsilon(1e-5));
    before = area;
  }
}

TEST_CASE("k-DOPs with axes are a brick's own box", "[hulls]") {
  for (const std::uint32_t slabs : {kAxes, kAxes | kCubeDiagonals, kAxes | kFaceDiagonals, kAll}) {
    checkMeasure(kdopVolume(slabs), kBrick, 88.0, 48.0);
  }
}

TEST_CASE("A k-DOP about a triangle across the cube's corner is the triangle", "[hulls]") {
  const std::vector<Shape> triangle = {test::triangleShape({1, 0, 0}, {0, 1, 0}, {0, 0, 1})};
  checkMeasure(kdopVolume(kAxes | kCubeDiagonals), triangle, std::sqrt(3.0), 0.0);
}

TEST_CASE("A box and sphere are as large as the smaller of the two", "[hulls]") {
  checkMeasure(boxAndSphere(), kBall, pi, pi / 6.0);
  checkMeasure(boxAndSphere(), kBrick, 88.0, 48.0);
}

TEST_CASE("k-DOPs have records for the groups of three slabs that they reach", "[hulls]") {
  CHECK(kdopVolume(kAxes).texels == 2);
  CHECK(kdopVolume(kCubeDiagonals).texels == 6);
  CHECK(kdopVolume(kAll).texels == 10);
  CHECK(kdopVolume(kAll).groups == 5);
}

}  // namespace
}  // namespace twintrace
