#include "common/cast/case_set.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/unit/cast/case_fixtures.h"

namespace twintrace {
namespace {

using test::primitiveOf;

TEST_CASE("normalised cases have no denormal values", "[cast][cases]") {
  const auto sphere = primitiveOf(CaseKind::sphere, {1e-40f, -1e-45f, 1e-37f, -1e-39f});
  CHECK(sphere.values[0] == 0.0f);
  CHECK(sphere.values[1] == 0.0f);
  CHECK(std::signbit(sphere.values[1]));
  CHECK(sphere.values[2] == 1e-37f);
  CHECK(sphere.values[3] == 0.0f);
}

TEST_CASE("normalised cases have sizes above zero and box bounds in order", "[cast][cases]") {
  CHECK(primitiveOf(CaseKind::sphere, {0, 0, 0, -2}).values[3] == 2.0f);
  const auto box = primitiveOf(CaseKind::box, {1, -2, 3, -1, 2, 3});
  CHECK(box.vector(0) == glm::vec3(-1, -2, 3));
  CHECK(box.vector(3) == glm::vec3(1, 2, 3));
  const auto turned =
      primitiveOf(CaseKind::orientedBox, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 2, -3});
  CHECK(turned.vector(12) == glm::vec3(1, 2, 3));
  const auto triangle = primitiveOf(CaseKind::triangle, {1, 0, 0, -1, 0, 0, 0, -1, 0});
  CHECK(triangle.vector(0) == glm::vec3(1, 0, 0));
}

TEST_CASE("a normalised ray has no denormal components", "[cast][cases]") {
  const CastRay ray = normalised(CastRay{{1e-40f, 1, 2}, {-1e-45f, 0, 1}, 1e-39f, 1e-38f});
  CHECK(ray.origin == glm::vec3(0, 1, 2));
  CHECK(ray.direction == glm::vec3(0, 0, 1));
  CHECK(ray.tmin == 0.0f);
  CHECK(ray.tmax == 0.0f);
}

}  // namespace
}  // namespace twintrace
