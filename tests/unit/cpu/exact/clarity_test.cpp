#include "cpu/exact/clarity.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <random>
#include <sstream>

#include "common/cast/case_csv.h"
#include "cpu/exact/arbiter.h"
#include "tests/catch.h"
#include "tests/unit/cpu/exact/one_ray.h"

namespace twintrace {
namespace {

using test::casesOf;
using test::decide;
using test::primitive;
constexpr float kUlp = 0x1p-23f;

/// Whether every ray of the line x = side + ulps * 2^-23 is as clear as expected, along +z from z =
/// 0 through what lies around z = 1 and has no coordinate beyond 1: M = 1.
Clarity clarityBeside(const CasePrimitive& target, float ulps) {
  return decide({target}, {{0.5f + ulps * kUlp, 0, 0}, {0, 0, 1}}).clarity;
}

void expectRim(const CasePrimitive& target) {
  CHECK(clarityBeside(target, -10) == Clarity::clean);
  CHECK(clarityBeside(target, -6) == Clarity::ambiguous);
  CHECK(clarityBeside(target, 0) == Clarity::ambiguous);
  CHECK(clarityBeside(target, 6) == Clarity::ambiguous);
  CHECK(clarityBeside(target, 10) == Clarity::clean);
}

TEST_CASE("a ray is ambiguous within 8 ulp of a sphere's rim", "[exact]") {
  // |centre| + radius = 1, and the far side's z is 1: M = 1.
  expectRim(primitive(CaseKind::sphere, {0, 0, 0.5f, 0.5f}));
}

TEST_CASE("a ray is ambiguous within 8 ulp of a box's edge", "[exact]") {
  expectRim(primitive(CaseKind::box, {-0.5f, -0.5f, 0.5f, 0.5f, 0.5f, 1}));
}

TEST_CASE("a ray is ambiguous within 8 ulp of an oriented box's edge", "[exact]") {
  // Axes of length 2: what counts is the move in scene units. M is 0.75 here.
  const CasePrimitive box =
      primitive(CaseKind::orientedBox, {0, 0, 0.25f, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 1, 1});
  CHECK(clarityBeside(box, -7) == Clarity::clean);
  CHECK(clarityBeside(box, -5) == Clarity::ambiguous);
  CHECK(clarityBeside(box, 5) == Clarity::ambiguous);
  CHECK(clarityBeside(box, 7) == Clarity::clean);
}

TEST_CASE("a ray is ambiguous within 8 ulp of a triangle's rim", "[exact]") {
  expectRim(primitive(CaseKind::triangle, {0.5f, -1, 1, 0.5f, 1, 1, -1, 0, 1}));
}

TEST_CASE("a ray that sees a triangle edge on is ambiguous where it touches", "[exact]") {
  const CasePrimitive sail = primitive(CaseKind::triangle, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  CHECK(decide({sail}, {{-1, 0.25f, 0}, {1, 0, 0}}).clarity == Clarity::ambiguous);
  CHECK(decide({sail}, {{-1, 0.25f, 0.1f}, {1, 0, 0}}).clarity == Clarity::clean);
}

TEST_CASE("a ray is ambiguous where its interval ends within 8 ulp of a surface", "[exact]") {
  const CasePrimitive wall = primitive(CaseKind::plane, {0, 0, 1, 0, 0, 1});
  const auto clarity = [&](float tmin, float tmax) {
    return decide({wall}, {{0, 0, 0}, {0, 0, 1}, tmin, tmax}).clarity;
  };
  CHECK(clarity(0, 1 + 10 * kUlp) == Clarity::clean);
  CHECK(clarity(0, 1 + 6 * kUlp) == Clarity::ambiguous);
  CHECK(clarity(0, 1 - 6 * kUlp) == Clarity::ambiguous);
  CHECK(clarity(0, 1 - 10 * kUlp) == Clarity::clean);
  CHECK(clarity(1 - 10 * kUlp, 2) == Clarity::clean);
  CHECK(clarity(1 - 6 * kUlp, 2) == Clarity::ambiguous);
  CHECK(clarity(1 + 6 * kUlp, 2) == Clarity::ambiguous);
  CHECK(clarity(1 + 10 * kUlp, 2) == Clarity::clean);
}

TEST_CASE("a ray from a surface is ambiguous, from further inside clean", "[exact]") {
  const CasePrimitive box = primitive(CaseKind::box, {0, -1, -1, 1, 1, 1});
  CHECK(decide({box}, {{0, 0, 0}, {1, 0, 0}}).clarity == Clarity::ambiguous);
  const ExactHit inside = decide({box}, {{10 * kUlp, 0, 0}, {1, 0, 0}});
  CHECK(inside.leaving);
  CHECK(inside.clarity == Clarity::clean);
}

TEST_CASE("a ray is ambiguous where the second surface is within reach of the first", "[exact]") {
  const CasePrimitive first = primitive(CaseKind::plane, {0, 0, 1, 0, 0, 1});
  const auto clarity = [&](float gap) {
    return decide({first, primitive(CaseKind::plane, {0, 0, 1, 0, 0, 1 + gap})},
                  {{0, 0, 0}, {0, 0, 1}})
        .clarity;
  };
  CHECK(clarity(0) == Clarity::tie);
  CHECK(clarity(14 * kUlp) == Clarity::ambiguous);
  CHECK(clarity(20 * kUlp) == Clarity::clean);
}

TEST_CASE("a ray is ambiguous within 8 ulp of a plane's direction", "[exact]") {
  const CasePrimitive ground = primitive(CaseKind::plane, {0, 1, 0, 0, 0, 0});
  CHECK(decide({ground}, {{0, 1, 0}, {1, -10 * kUlp, 0}}).clarity == Clarity::clean);
  CHECK(decide({ground}, {{0, 1, 0}, {1, -6 * kUlp, 0}}).clarity == Clarity::ambiguous);
  CHECK(decide({ground}, {{0, 1, 0}, {1, 0, 0}}).clarity == Clarity::ambiguous);
  CHECK(decide({ground}, {{0, 1, 0}, {1, 0, 0}, 0, 1000}).clarity == Clarity::clean);
}

TEST_CASE("M counts how far the ray goes", "[exact]") {
  // The same rim, seen from 1024 away.
  const CasePrimitive ball = primitive(CaseKind::sphere, {0, 0, 0.5f, 0.5f});
  const auto clarity = [&](float ulps) {
    return decide({ball}, {{0.5f - ulps * kUlp, 0, -1024}, {0, 0, 1}}).clarity;
  };
  CHECK(clarity(10) == Clarity::ambiguous);
  CHECK(clarity(7 * 1024) == Clarity::ambiguous);
  CHECK(clarity(9 * 1024) == Clarity::clean);
}

TEST_CASE("tUnit is the change of t as the surface moves by 1 ulp(M)", "[exact]") {
  const CasePrimitive slope = primitive(CaseKind::plane, {0, 1, 1, 0, 0, 4});
  const ExactHit hit = decide({slope}, {{0, 0, 0}, {0, 0, 2}});
  CHECK(hit.t == 2.0);
  CHECK(hit.tUnit == Approx(4 * 0x1p-23 * std::sqrt(2.0) / 2.0));
  const CasePrimitive ball = primitive(CaseKind::sphere, {0, 0, 0, 1});
  const ExactHit glance = decide({ball}, {{0.8f, 0, -4}, {0, 0, 1}});
  CHECK(glance.tUnit == Approx(4 * 0x1p-23 / 0.6).epsilon(1e-3));
}

TEST_CASE("another face of a box is beside the hit if moves by 8 ulp reach it", "[exact]") {
  const CasePrimitive box = primitive(CaseKind::box, {-1, -1, -1, 1, 1, 1});
  const auto entering = [&](float ulps) {  // M = 2; either face moves by half of that
    return decide({box}, {{-2 + 2 * ulps * kUlp, -2, 0}, {1, 1, 0}});
  };
  CHECK(entering(15).normal == glm::dvec3(0, -1, 0));
  REQUIRE(entering(15).facesBeside.size() == 1);
  CHECK(entering(15).facesBeside[0].normal == glm::dvec3(-1, 0, 0));
  CHECK(entering(15).facesBeside[0].t == 1.0 - 30 * double(kUlp));
  CHECK(entering(15).facesBeside[0].tUnit == Approx(2 * double(kUlp)));
  CHECK(entering(17).facesBeside.empty());
  const auto leaving = [&](float ulps) {  // M = 1
    return decide({box}, {{ulps * kUlp, 0, 0}, {1, 1, 0}});
  };
  CHECK(leaving(15).normal == glm::dvec3(1, 0, 0));
  REQUIRE(leaving(15).facesBeside.size() == 1);
  CHECK(leaving(15).facesBeside[0].normal == glm::dvec3(0, 1, 0));
  CHECK(leaving(17).facesBeside.empty());
}

TEST_CASE("the back of a thin box is not beside its front", "[exact]") {
  const CasePrimitive sheet = primitive(CaseKind::box, {-1, 0, -1, 1, 0, 1});
  CHECK(decide({sheet}, {{0, 2, 0}, {0.1f, -1, 0.1f}}).facesBeside.empty());
}

TEST_CASE("moves of an oriented box's faces are in scene units", "[exact]") {
  const CasePrimitive box =
      primitive(CaseKind::orientedBox, {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 2, 2, 2});
  const auto leaving = [&](float ulps) {  // M = 1
    return decide({box}, {{ulps * kUlp, 0, 0}, {1, 1, 0}});
  };
  REQUIRE(leaving(15).facesBeside.size() == 1);
  CHECK(leaving(15).facesBeside[0].normal == glm::dvec3(0, 1, 0));
  CHECK(leaving(15).facesBeside[0].tUnit == Approx(double(kUlp)));
  CHECK(leaving(17).facesBeside.empty());
}

/// Moves every number of the inputs by up to 1 ulp(M): what then happens to a clean ray's answer
/// has moved by no more than the 8 ulp that its surfaces may.
TEST_CASE("small changes of all inputs leave clean answers as they are", "[exact]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::uniform_int_distribution<int> kindOf(0, 4);
  int clean = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<CasePrimitive> primitives(3);
    for (CasePrimitive& one : primitives) {
      one.kind = static_cast<CaseKind>(kindOf(random));
      for (float& value : one.values) value = uniform(random);
      one = normalised(one);
    }
    CastRay ray{{uniform(random), uniform(random), uniform(random)}, {}};
    // Towards what is hard, though not quite: a corner, vertex or rim, missed by some ulp.
    ray.direction = primitives[0].vector(0) - ray.origin;
    if (primitives[0].kind == CaseKind::sphere) {
      const glm::vec3 aside = glm::normalize(glm::cross(ray.direction, glm::vec3(1, 2, 3)));
      ray.direction += aside * primitives[0].values[3];
    }
    ray.direction += 20.0f * kUlp * glm::vec3(uniform(random), uniform(random), uniform(random));
    const ExactHit before = decide(primitives, ray);
    if (before.clarity != Clarity::clean) continue;
    ++clean;
    const auto moved = [&](float value) { return value + kUlp * uniform(random); };
    for (int k = 0; k < 20; ++k) {
      std::vector<CasePrimitive> others = primitives;
      for (CasePrimitive& one : others) {
        for (float& value : one.values) value = moved(value);
        one = normalised(one);
      }
      CastRay other = ray;
      for (int axis = 0; axis < 3; ++axis) {
        other.origin[axis] = moved(other.origin[axis]);
        other.direction[axis] *= 1.0f + 0.5f * kUlp * uniform(random);
      }
      std::ostringstream replay;
      writeCases(replay, casesOf(primitives, ray));
      writeCases(replay, casesOf(others, other));
      INFO(replay.str());
      const ExactHit after = decide(others, other);
      REQUIRE(after.primitive == before.primitive);
      REQUIRE(after.leaving == before.leaving);
    }
  }
  CHECK(clean > 500);
}

}  // namespace
}  // namespace twintrace
