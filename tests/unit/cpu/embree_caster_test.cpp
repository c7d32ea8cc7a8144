#include "cpu/embree_caster.h"

#include <glm/geometric.hpp>
#include <limits>

#include "tests/catch.h"
#include "tests/unit/cpu/caster_fixtures.h"

namespace twintrace {
namespace {

using test::flatSceneOf;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

CastHit castOne(RayCaster& caster, const CastRay& ray) {
  return caster.cast({&ray, 1}).at(0);
}

/// Six rays at the faces of a box of size 2, or the poles of a unit sphere, from outside and
/// inside.
void expectOutwardNormals(RayCaster& caster, const glm::vec3& center, int primitive) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 outward(0.0f);
      outward[axis] = side;
      glm::vec3 aside(0.1f, 0.2f, 0.15f);  // off the triangles' common edges
      aside[axis] = 0.0f;
      for (const float from : {3.0f, 0.0f}) {
        const glm::vec3 towards = from > 1.0f ? -outward : outward;
        const CastHit hit = castOne(caster, {center + aside + outward * from, towards});
        INFO("axis " << axis << ", side " << side << ", from " << from);
        REQUIRE(hit.primitive == primitive);
        CHECK(glm::length(hit.normal) == Approx(1.0f));
        CHECK(glm::dot(hit.normal, outward) > 0.9f);
      }
    }
  }
}

TEST_CASE("embree caster misses along rays without numbers or direction", "[cpu][embree]") {
  const auto caster = makeEmbreeCaster(
      flatSceneOf({SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f},
                   BoxShape{{0.0f, 0.0f, 3.0f}, glm::vec3(2.0f), glm::vec3(0.0f)}}));
  const glm::vec3 origin(0.0f, 0.0f, -5.0f);
  const glm::vec3 ahead(0.0f, 0.0f, 1.0f);
  CHECK(castOne(*caster, {origin, ahead}).valid());
  CHECK(castOne(*caster, {origin, ahead, 0.0f, kInfinity}).valid());
  CHECK_FALSE(castOne(*caster, {origin, {0.0f, 0.0f, 0.0f}}).valid());
  CHECK_FALSE(castOne(*caster, {origin, {kNan, 0.0f, 1.0f}}).valid());
  CHECK_FALSE(castOne(*caster, {{0.0f, kInfinity, 0.0f}, ahead}).valid());
  CHECK_FALSE(castOne(*caster, {origin, ahead, kNan, 9.0f}).valid());
  CHECK_FALSE(castOne(*caster, {origin, ahead, 0.0f, 3.0f}).valid());
}

TEST_CASE("embree caster numbers primitives as the flat scene and gives outward normals",
          "[cpu][embree]") {
  const auto scene = flatSceneOf(
      {BoxShape{{20.0f, 0.0f, 0.0f}, glm::vec3(2.0f), {}},
       BoxShape{{30.0f, 0.0f, 0.0f}, glm::vec3(2.0f), glm::vec3(1, 2, 3)},
       SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f}, BoxShape{{40.0f, 0.0f, 0.0f}, glm::vec3(2.0f), {}},
       SphereShape{{10.0f, 0.0f, 0.0f}, 1.0f}});
  const auto caster = makeEmbreeCaster(scene);
  for (int i = 0; i < 2; ++i) expectOutwardNormals(*caster, {10.0f * i, 0.0f, 0.0f}, i);
  expectOutwardNormals(*caster, {20.0f, 0.0f, 0.0f}, 2);
  expectOutwardNormals(*caster, {40.0f, 0.0f, 0.0f}, 3);
  expectOutwardNormals(*caster, {30.0f, 0.0f, 0.0f}, 4);
}

TEST_CASE("embree caster counts the planes that it leaves out", "[cpu][embree]") {
  const auto caster = makeEmbreeCaster(flatSceneOf({PlaneShape{}, SphereShape{}, PlaneShape{}}));
  CHECK(caster->leftOut() == 2);
  CHECK(caster->name() == "embree");
  CHECK_FALSE(castOne(*caster, {{5.0f, 5.0f, 0.0f}, {0.0f, -1.0f, 0.0f}}).valid());
}

TEST_CASE("embree caster leaves out what the effects leave out", "[cpu][embree]") {
  FlatScene scene = *flatSceneOf(
      {SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f}, BoxShape{{0.0f, 0.0f, 4.0f}, glm::vec3(2.0f), {}},
       BoxShape{{0.0f, 0.0f, 8.0f}, glm::vec3(2.0f), glm::vec3(0, 0, 5)}});
  scene.effects.set(Effect::sphere, false);
  scene.effects.set(Effect::box, false);
  const auto caster = makeEmbreeCaster(std::make_shared<const FlatScene>(scene));
  CHECK(castOne(*caster, {{0.1f, 0.2f, -5.0f}, {0.0f, 0.0f, 1.0f}}).primitive == 2);
}

}  // namespace
}  // namespace twintrace
