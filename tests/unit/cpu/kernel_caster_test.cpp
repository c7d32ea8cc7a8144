#include "cpu/kernel_caster.h"

#include <bit>
#include <limits>
#include <random>

#include "common/base/flush_denormals.h"
#include "cpu/kernel/surface.h"
#include "cpu/kernel/traverse.h"
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

RenderOptions doubleOptions() {
  RenderOptions options;
  options.precision = Precision::float64;
  return options;
}

std::shared_ptr<const FlatScene> unitSphere() {
  return flatSceneOf({SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f}});
}

// Inside a box and a sphere: what slabs drop or multiply to zero would be a hit.
TEST_CASE("kernel caster misses along rays without numbers or direction", "[cpu][cast]") {
  const auto scene = flatSceneOf({BoxShape{{0.0f, 0.0f, 0.0f}, glm::vec3(2.0f), {}},
                                  SphereShape{{0.0f, 0.0f, 0.0f}, 2.0f},
                                  BoxShape{{0.0f, 0.0f, 0.0f}, glm::vec3(6.0f), glm::vec3(5.0f)}});
  const glm::vec3 inside(0.25f, 0.5f, 0.75f);
  const glm::vec3 ahead(0.0f, 0.0f, 1.0f);
  for (const RenderOptions& options : {RenderOptions{}, doubleOptions()}) {
    const auto caster = makeKernelCaster(scene, options);
    REQUIRE(castOne(*caster, {inside, ahead}).valid());
    for (const float bad : {kNan, kInfinity, -kInfinity}) {
      for (int axis = 0; axis < 3; ++axis) {
        CastRay ray{inside, ahead};
        ray.origin[axis] = bad;
        CHECK_FALSE(castOne(*caster, ray).valid());
        ray = {inside, ahead};
        ray.direction[axis] = bad;
        CHECK_FALSE(castOne(*caster, ray).valid());
      }
    }
    CHECK_FALSE(castOne(*caster, {inside, ahead, kNan, 9.0f}).valid());
    CHECK_FALSE(castOne(*caster, {inside, ahead, 0.0f, kNan}).valid());
    CHECK_FALSE(castOne(*caster, {inside, ahead, 9.0f, 0.0f}).valid());
    for (const float zero : {0.0f, -0.0f, 1e-40f}) {
      CHECK_FALSE(castOne(*caster, {inside, {zero, 0.0f, zero}}).valid());
      CHECK_FALSE(castOne(*caster, {{5.0f, 0.0f, 0.0f}, {0.0f, zero, 0.0f}}).valid());
    }
  }
}

TEST_CASE("kernel caster reads denormals as zero", "[cpu][cast]") {
  const auto caster =
      makeKernelCaster(flatSceneOf({BoxShape{{0.0f, 0.0f, 1.0f}, glm::vec3(2.0f), {}}}), {});
  const CastHit hit = castOne(*caster, {glm::vec3(0.0f), {0.0f, 0.0f, 1.0f}, 1e-40f, 9.0f});
  CHECK(hit.valid());
  CHECK(hit.t == 0.0f);
}

TEST_CASE("kernel caster takes an infinite end of the interval", "[cpu][cast]") {
  const auto caster = makeKernelCaster(unitSphere(), {});
  const glm::vec3 ahead(0.0f, 0.0f, 1.0f);
  CHECK(castOne(*caster, {{0.0f, 0.0f, -5.0f}, ahead, 0.0f, kInfinity}).t == 4.0f);
  CHECK_FALSE(castOne(*caster, {{0.0f, 0.0f, 5.0f}, ahead, 0.0f, kInfinity}).valid());
}

TEST_CASE("kernel caster gives outward normals, also from inside", "[cpu][cast]") {
  const auto scene = flatSceneOf(
      {SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f}, BoxShape{{10.0f, 0.0f, 0.0f}, glm::vec3(2.0f), {}},
       BoxShape{{20.0f, 0.0f, 0.0f}, glm::vec3(2.0f), glm::vec3(0, 90, 0)},
       PlaneShape{{0.0f, -5.0f, 0.0f}, {0.0f, 1.0f, 0.0f}}});
  for (const RenderOptions& options : {RenderOptions{}, doubleOptions()}) {
    const auto caster = makeKernelCaster(scene, options);
    const glm::vec3 right(1.0f, 0.0f, 0.0f);
    CHECK(castOne(*caster, {{-3.0f, 0.0f, 0.0f}, right}).normal == -right);
    CHECK(castOne(*caster, {{0.0f, 0.0f, 0.0f}, right}).normal == right);
    CHECK(castOne(*caster, {{5.0f, 0.0f, 0.0f}, right}).normal == -right);
    CHECK(castOne(*caster, {{10.0f, 0.0f, 0.0f}, right}).normal == right);
    CHECK(castOne(*caster, {{20.0f, 0.0f, 0.0f}, right}).normal.x == Approx(1.0f));
    const CastHit floor = castOne(*caster, {{5.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}});
    CHECK(floor.primitive == 3);
    CHECK(floor.normal == glm::vec3(0.0f, 1.0f, 0.0f));
  }
}

TEST_CASE("kernel caster measures t in lengths of the direction", "[cpu][cast]") {
  const auto caster = makeKernelCaster(unitSphere(), {});
  CHECK(castOne(*caster, {{0.0f, 0.0f, -5.0f}, {0.0f, 0.0f, 4.0f}}).t == 1.0f);
}

TEST_CASE("kernel caster in double rounds once, at the end", "[cpu][cast]") {
  const auto caster = makeKernelCaster(unitSphere(), doubleOptions());
  CHECK(caster->name() == "cpu64");
  // 5 - sqrt(1 - 0.3f^2), rounded to float
  const float t = static_cast<float>(5.0 - std::sqrt(1.0 - double(0.3f) * 0.3f));
  CHECK(castOne(*caster, {{0.3f, 0.0f, -5.0f}, {0.0f, 0.0f, 1.0f}}).t == t);
}

TEST_CASE("kernel caster answers many rays in their order, for any number of threads and hull",
          "[cpu][cast]") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<float> number(-3.0f, 3.0f);
  const auto vector = [&] { return glm::vec3(number(engine), number(engine), number(engine)); };
  std::vector<test::Shape> shapes;
  for (int i = 0; i < 20; ++i) shapes.emplace_back(SphereShape{vector(), 0.4f});
  for (int i = 0; i < 20; ++i) shapes.emplace_back(BoxShape{vector(), glm::vec3(0.6f), vector()});
  const auto scene = flatSceneOf(shapes);
  std::vector<CastRay> rays(20000);
  for (CastRay& ray : rays) ray = {vector(), vector()};
  RenderOptions one;
  one.threads = 1;
  RenderOptions embree;
  embree.hull = "embree";
  RenderOptions native;
  native.maths = Maths::native;
  const auto caster = makeKernelCaster(scene, one);
  CHECK(caster->name() == "cpu");
  const std::vector<CastHit> expected = caster->cast(rays);
  REQUIRE(expected.size() == rays.size());
  const kernel::SceneView view = kernel::viewScene(*scene, {}, nullptr);
  const std::vector<CastHit> byHull = makeKernelCaster(scene, embree)->cast(rays);
  const std::vector<CastHit> byNative = makeKernelCaster(scene, native)->cast(rays);
  const FlushDenormals flush;
  int different = 0;
  int hitCount = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto ray = kernel::makeRay(kernel::toVec3(rays[i].origin),
                                     kernel::toVec3(rays[i].direction), 0.0f, kernel::kLargest);
    const kernel::Hit<float> hit = kernel::closestHit(view, ray);
    const bool valid = hit.primitive != kernel::kNoPrimitive;
    hitCount += valid;
    different += expected[i].primitive != (valid ? hit.primitive : -1);
    different += expected[i].t != (valid ? hit.t : 0.0f);
    for (const CastHit& other : {byHull[i], byNative[i]}) {
      different += other.primitive != expected[i].primitive || other.t != expected[i].t;
    }
    different += byHull[i].normal != expected[i].normal;
  }
  CHECK(different == 0);
  CHECK(hitCount > 1000);
}

}  // namespace
}  // namespace twintrace
