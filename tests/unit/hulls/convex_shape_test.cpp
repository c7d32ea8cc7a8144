#include "common/hulls/convex_shape.h"

#include <glm/geometric.hpp>
#include <limits>

#include "common/scene/rotation.h"
#include "tests/catch.h"
#include "tests/unit/hulls/convex_fixtures.h"

namespace twintrace {
namespace {

using test::flatSceneOf;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST_CASE("The support of a sphere is its center's and its radius", "[hulls]") {
  const auto scene = flatSceneOf({SphereShape{{1, 2, 3}, 0.5f}});
  const ConvexShape shape = convexShape(*scene, 0);
  for (const glm::dvec3& n : test::testDirections()) {
    CHECK(shape.support(n) == Approx(glm::dot(n, glm::dvec3(1, 2, 3)) + 0.5));
    CHECK(shape.support(3.0 * n) == Approx(3.0 * shape.support(n)));
  }
}

TEST_CASE("The support of a box is that of a corner", "[hulls]") {
  const auto scene = flatSceneOf({BoxShape{{1, 2, 3}, {2, 4, 6}, {}}});
  const ConvexShape shape = convexShape(*scene, 0);
  for (const glm::dvec3& n : test::testDirections()) {
    const double half = std::abs(n.x) + 2.0 * std::abs(n.y) + 3.0 * std::abs(n.z);
    CHECK(shape.support(n) == Approx(glm::dot(n, glm::dvec3(1, 2, 3)) + half));
  }
}

TEST_CASE("The support of an oriented box turns with it", "[hulls]") {
  const glm::vec3 rotation(20, 40, 60);
  const auto scene = flatSceneOf({BoxShape{{1, 2, 3}, {2, 4, 6}, rotation}});
  REQUIRE(scene->index.orientedBoxCount == 1);
  const ConvexShape shape = convexShape(*scene, 0);
  const glm::dmat3 axes = rotationMatrix(rotation);
  for (const glm::dvec3& n : test::testDirections()) {
    const double half = std::abs(glm::dot(n, axes[0])) + 2.0 * std::abs(glm::dot(n, axes[1])) +
                        3.0 * std::abs(glm::dot(n, axes[2]));
    // The record's axes are floats.
    CHECK(shape.support(n) == Approx(glm::dot(n, glm::dvec3(1, 2, 3)) + half).margin(1e-6));
  }
}

TEST_CASE("The support of a triangle is that of a vertex", "[hulls]") {
  const auto scene = flatSceneOf({test::triangleShape({0, 0, 0}, {1, 0, 0}, {0, 2, 0})});
  const ConvexShape shape = convexShape(*scene, 0);
  for (const glm::dvec3& n : test::testDirections()) {
    CHECK(shape.support(n) == Approx(std::max({0.0, n.x, 2.0 * n.y})));
  }
}

TEST_CASE("convexShape numbers primitives as the scene does, planes left out", "[hulls]") {
  const auto scene =
      flatSceneOf({PlaneShape{}, test::triangleShape({0, 0, 4}, {1, 0, 4}, {0, 1, 4}),
                   BoxShape{{0, 0, 3}, glm::dvec3(1.0), glm::vec3(45.0f)},
                   BoxShape{{0, 0, 2}, glm::dvec3(1.0), {}}, SphereShape{{0, 0, 1}, 1.0f}});
  REQUIRE(scene->index.boundedCount() == 4);
  for (int i = 0; i < 4; ++i) {
    const ConvexShape shape = convexShape(*scene, i);
    const double middle = (shape.support({0, 0, 1}) - shape.support({0, 0, -1})) / 2.0;
    CHECK(middle == Approx(i + 1.0));
  }
}

TEST_CASE("boundsOf holds a shape and no more than the next floats", "[hulls]") {
  const auto scene = flatSceneOf(test::mixedShapes(40, 3));
  for (int i = 0; i < scene->index.boundedCount(); ++i) {
    const ConvexShape shape = convexShape(*scene, i);
    const Bounds bounds = boundsOf(shape);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 n(0.0);
      n[axis] = 1.0;
      CHECK(bounds.high[axis] >= shape.support(n));
      CHECK(std::nextafter(bounds.high[axis], -kInfinity) < shape.support(n));
      CHECK(bounds.low[axis] <= -shape.support(-n));
      CHECK(std::nextafter(bounds.low[axis], kInfinity) > -shape.support(-n));
    }
  }
}

TEST_CASE("roundedDown and roundedUp give the floats on either side", "[hulls]") {
  for (const double x : {0.1, -0.1, 1.0 + 1e-12, -1.0 - 1e-12, 1e-50, -1e-50, 1e30}) {
    CHECK(double(roundedDown(x)) < x);
    CHECK(double(roundedUp(x)) > x);
    CHECK(std::nextafter(roundedDown(x), kInfinity) == roundedUp(x));
  }
  for (const double x : {0.0, 0.5, -3.0}) {
    CHECK(roundedDown(x) == float(x));
    CHECK(roundedUp(x) == float(x));
  }
}

TEST_CASE("Bounds grow by what is added and have half a box's area", "[hulls]") {
  Bounds bounds = Bounds::nothing();
  CHECK(bounds.halfArea() == 0.0f);
  bounds.add(glm::vec3(1, 2, 3));
  CHECK(bounds.halfArea() == 0.0f);
  bounds.add(Bounds{{0, 0, 0}, {2, 1, 1}});
  CHECK(bounds.low == glm::vec3(0, 0, 0));
  CHECK(bounds.high == glm::vec3(2, 2, 3));
  CHECK(bounds.halfArea() == 2.0f * 2.0f + 2.0f * 3.0f + 3.0f * 2.0f);
  CHECK(bounds.center() == glm::vec3(1.0f, 1.0f, 1.5f));
}

}  // namespace
}  // namespace twintrace
