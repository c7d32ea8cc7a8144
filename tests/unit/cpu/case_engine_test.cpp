#include "cpu/case_engine.h"

#include <glm/geometric.hpp>
#include <limits>

#include "common/trace/options.h"
#include "cpu/embree_case_engine.h"
#include "tests/catch.h"
#include "tests/unit/cast/case_fixtures.h"

namespace twintrace {
namespace {

using namespace test;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();

std::unique_ptr<CaseEngine> engineOf(Intersector intersector,
                                     Precision precision = Precision::float32) {
  RenderOptions options;
  options.intersector = intersector;
  options.precision = precision;
  return makeKernelCaseEngine(options);
}

std::unique_ptr<CaseEngine> robust() {
  return engineOf(Intersector::robust);
}

const CastRay kDown{{0.1f, 0.2f, 4.0f}, {0.0f, 0.0f, -1.0f}};

void expectHit(CaseEngine& engine, const CasePrimitive& primitive, float t) {
  const CastHit hit = castOne(engine, {primitive}, kDown);
  REQUIRE(hit.primitive == 0);
  CHECK(hit.t == Approx(t));
  CHECK(glm::length(hit.normal) == Approx(1.0f));
  CHECK(hit.normal.z > 0.9f);
}

TEST_CASE("case engines hit and miss each kind of primitive", "[cpu][cases]") {
  const CastRay aside{{5.0f, 0.2f, 4.0f}, {0.0f, 0.0f, -1.0f}};
  for (const auto& engine : {robust(), engineOf(Intersector::report),
                             engineOf(Intersector::robust, Precision::float64)}) {
    INFO(engine->name());
    expectHit(*engine, unitSphere(), 4.0f - std::sqrt(1.0f - 0.05f));
    expectHit(*engine, unitBox(), 3.0f);
    expectHit(*engine, turnedBox(), 3.0f);
    expectHit(*engine, groundPlane(), 4.0f);
    expectHit(*engine, flatTriangle(), 4.0f);
    for (const auto& primitive : {unitSphere(), unitBox(), turnedBox(), flatTriangle()}) {
      CHECK(castOne(*engine, {primitive}, aside).primitive == -1);
    }
    CHECK(castOne(*engine, {groundPlane()}, {{0, 0, 4}, {0, 0, 1}}).primitive == -1);
  }
}

TEST_CASE("case engines have the names of the command line", "[cpu][cases]") {
  CHECK(robust()->name() == "cpu");
  CHECK(engineOf(Intersector::robust, Precision::float64)->name() == "cpu64");
}

TEST_CASE("of equal distances a case has the first primitive", "[cpu][cases]") {
  const auto engine = robust();
  CHECK(castOne(*engine, {flatTriangle(), groundPlane()}, kDown).primitive == 0);
  CHECK(castOne(*engine, {groundPlane(), flatTriangle()}, kDown).primitive == 0);
  CHECK(castOne(*engine, {groundPlane(), unitBox()}, kDown).primitive == 1);
}

TEST_CASE("each ray of a case set sees its own scene only", "[cpu][cases]") {
  CaseSet cases;
  cases.primitives = {unitSphere(), unitBox(), groundPlane()};
  cases.scenes = {{0, 1}, {1, 2}, {0, 0}};
  for (const std::uint32_t scene : {1u, 0u, 2u}) cases.rays.push_back({kDown, scene});
  const auto hits = robust()->cast(cases);
  REQUIRE(hits.size() == 3);
  CHECK(hits[0].t == 3.0f);
  CHECK(hits[1].t > 3.0f);
  CHECK(hits[1].primitive == 0);
  CHECK(hits[2].primitive == -1);
}

TEST_CASE("a direction's length scales t exactly", "[cpu][cases]") {
  const auto engine = robust();
  for (const auto& primitive :
       {unitSphere(), unitBox(), turnedBox(), groundPlane(), flatTriangle()}) {
    const float t = castOne(*engine, {primitive}, kDown).t;
    for (int exponent = -126; exponent <= 126; exponent += 4) {
      CastRay ray = kDown;
      ray.direction *= std::exp2(static_cast<float>(exponent));
      const CastHit hit = castOne(*engine, {primitive}, ray);
      INFO("kind " << static_cast<int>(primitive.kind) << ", direction 2^" << exponent);
      const float expected = std::ldexp(t, -exponent);
      if (expected > kLargest) {
        CHECK(hit.primitive == -1);
      } else if (expected >= std::numeric_limits<float>::min()) {
        CHECK(hit.primitive == 0);
        CHECK(hit.t == expected);
      }
    }
  }
}

TEST_CASE("a case's scale scales t exactly", "[cpu][cases]") {
  const auto engine = robust();
  for (const auto& primitive : {unitSphere(), unitBox(), groundPlane(), flatTriangle()}) {
    const CastHit plain = castOne(*engine, {primitive}, kDown);
    for (int exponent = -120; exponent <= 124; exponent += 4) {
      const float scale = std::exp2(static_cast<float>(exponent));
      CasePrimitive scaled = primitive;
      for (float& value : scaled.values) value *= scale;
      CastRay ray = kDown;
      ray.origin *= scale;
      const CastHit hit = castOne(*engine, {scaled}, ray);
      INFO("kind " << static_cast<int>(primitive.kind) << ", scale 2^" << exponent);
      CHECK(hit.primitive == 0);
      CHECK(hit.t == plain.t * scale);
      CHECK(hit.normal == plain.normal);
    }
  }
}

TEST_CASE("a case reaches the largest coordinates", "[cpu][cases]") {
  const auto engine = robust();
  const auto far = primitiveOf(CaseKind::box, {-1, -1, 3e38f, 1, 1, 3.3e38f});
  CHECK(castOne(*engine, {far}, {{0, 0, 0}, {0, 0, 1}}).t == 3e38f);
  // The distance is more than the largest float.
  CHECK(castOne(*engine, {far}, {{0, 0, -3e38f}, {0, 0, 1}}).primitive == -1);
  CHECK(castOne(*engine, {far}, {{0, 0, -3e38f}, {0, 0, 4}}).t == Approx(1.5e38f));
  CHECK(castOne(*engine, {far}, {{0, 0, 0}, {0, 0, 0.5f}}).primitive == -1);
}

TEST_CASE("a case's interval is closed and in its own units", "[cpu][cases]") {
  const auto engine = robust();
  for (const float speed : {1.0f, 0x1p-100f, 0x1p+100f}) {
    const auto cast = [&](float tmin, float tmax) {
      return castOne(*engine, {unitBox()},
                     {kDown.origin, kDown.direction * speed, tmin / speed, tmax / speed});
    };
    INFO("direction " << speed);
    CHECK(cast(0.0f, 3.0f).primitive == 0);
    CHECK(cast(0.0f, std::nextafter(3.0f, 0.0f)).primitive == -1);
    CHECK(cast(3.0f, kInfinity).t == 3.0f / speed);
    CHECK(cast(std::nextafter(3.0f, 4.0f), kInfinity).t == 5.0f / speed);
    CHECK(cast(5.5f, kInfinity).primitive == -1);
    CHECK(cast(4.0f, 3.0f).primitive == -1);
  }
}

TEST_CASE("a positive start that underflows leaves out a hit at the origin", "[cpu][cases]") {
  const CastRay ray{{0, 0, 1e30f}, {0, 0, -1e-30f}, 1e-30f, kLargest};
  const auto plane = primitiveOf(CaseKind::plane, {0, 0, 1, 0, 0, 1e30f});
  CHECK(castOne(*robust(), {plane}, ray).primitive == -1);
}

TEST_CASE("a ray without numbers or direction misses", "[cpu][cases]") {
  const glm::vec3 origin = kDown.origin;
  const glm::vec3 down = kDown.direction;
  for (const auto intersector : {Intersector::robust, Intersector::report}) {
    const auto engine = engineOf(intersector);
    for (const auto& primitive :
         {unitSphere(), unitBox(), turnedBox(), groundPlane(), flatTriangle()}) {
      const auto misses = [&](const CastRay& ray) {
        return castOne(*engine, {primitive}, ray).primitive == -1;
      };
      CHECK_FALSE(misses({origin, down, 0.0f, kInfinity}));
      CHECK(misses({{kNan, 0, 4}, down}));
      CHECK(misses({{0, 0, kInfinity}, down}));
      CHECK(misses({origin, {0, kNan, -1}}));
      CHECK(misses({origin, {0, 0, -kInfinity}}));
      CHECK(misses({origin, {0, 0, 0}}));
      CHECK(misses({origin, {0, -0.0f, 1e-40f}}));
      CHECK(misses({origin, down, kNan, 9.0f}));
      CHECK(misses({origin, down, 0.0f, kNan}));
    }
  }
}

TEST_CASE("the report's intersector gets a direction as it is", "[cpu][cases]") {
  const auto engine = engineOf(Intersector::report);
  CastRay slow = kDown;
  slow.direction *= 1e-5f;
  CHECK(castOne(*engine, {groundPlane()}, slow).primitive == -1);
}

TEST_CASE("a bounce leaves the first hit and finds the second", "[cpu][cases]") {
  CaseSet cases = casesOf({groundPlane(), primitiveOf(CaseKind::plane, {0, 0, -1, 0, 0, 10})},
                          {kDown, {{0, 0, 4}, {1, 0, 0}}, {{1, 0, -4}, {0, 0, 1}}});
  cases.bounces = {{0.99f, 0.25f}, {0.5f, 0.5f}, {0.3f, 0.1f}};
  for (const auto intersector : {Intersector::robust, Intersector::report}) {
    const auto hits = engineOf(intersector)->cast(cases);
    CHECK(hits[0].primitive == 1);
    CHECK(hits[0].t > 9.99f);
    CHECK(hits[0].normal == glm::vec3(0, 0, -1));
    CHECK(hits[1].primitive == kBounceNotStarted);
    CHECK(hits[2].primitive == -1);  // it leaves on the side that it came from
  }
}

TEST_CASE("a bounce off a sphere in double does not hit it again, from far away too",
          "[cpu][cases]") {
  const auto engine = engineOf(Intersector::robust, Precision::float64);
  CaseSet cases;
  cases.primitives = {unitSphere()};
  cases.scenes = {{0, 1}};
  for (int i = 0; i < 1000; ++i) {
    const float part = static_cast<float>(i) / 1000.0f;
    const float distance = i % 2 == 0 ? 20.0f : 1000.0f;
    const glm::vec3 direction(0.5f * part, 0.3f, -1.0f);
    const glm::vec3 target(0.3f - 0.5f * part, 0.4f * part, 0.1f);
    cases.rays.push_back({{target - direction * distance, direction}, 0});
    cases.bounces.push_back({part, 0.999f - 0.9f * part});
  }
  for (const CastHit& hit : engine->cast(cases)) CHECK(hit.primitive == -1);
}

TEST_CASE("an engine without rays or primitives has nothing to do", "[cpu][cases]") {
  CHECK(robust()->cast(CaseSet()).empty());
  CHECK(castOne(*robust(), {}, kDown).primitive == -1);
}

TEST_CASE("embree's case engine hits each kind that it has", "[cpu][cases][embree]") {
  const auto engine = makeEmbreeCaseEngine();
  CHECK(engine->name() == "embree");
  CHECK_FALSE(engine->canBounce());
  CHECK_FALSE(engine->has(CaseKind::plane));
  expectHit(*engine, unitSphere(), 4.0f - std::sqrt(1.0f - 0.05f));
  expectHit(*engine, unitBox(), 3.0f);
  expectHit(*engine, turnedBox(), 3.0f);
  expectHit(*engine, flatTriangle(), 4.0f);
  CHECK(castOne(*engine, {groundPlane()}, kDown).primitive == -1);
  CHECK(castOne(*engine, {groundPlane(), flatTriangle()}, kDown).primitive == 1);
  CHECK(castOne(*engine, {unitSphere()}, {{kNan, 0, 4}, {0, 0, -1}}).primitive == -1);
}

TEST_CASE("embree's case engine numbers the primitives of mixed scenes", "[cpu][cases][embree]") {
  CaseSet cases;
  for (int i = 0; i < 12; ++i) {
    CasePrimitive primitive[] = {flatTriangle(), groundPlane(), turnedBox(), unitSphere(),
                                 unitBox()};
    CasePrimitive& chosen = primitive[i % 5];
    for (std::size_t value = 0; value < 9; value += 3) {
      if (value == 0 || chosen.kind == CaseKind::triangle ||
          (value == 3 && chosen.kind == CaseKind::box)) {
        chosen.values[value] += 10.0f * static_cast<float>(i);
      }
    }
    cases.primitives.push_back(chosen);
    CastRay ray = kDown;
    ray.origin.x += 10.0f * static_cast<float>(i);
    cases.rays.push_back({ray, 0});
  }
  cases.scenes = {{0, 12}};
  const auto hits = makeEmbreeCaseEngine()->cast(cases);
  for (int i = 0; i < 12; ++i)
    CHECK(hits[static_cast<std::size_t>(i)].primitive == (i % 5 == 1 ? -1 : i));
}

}  // namespace
}  // namespace twintrace
