#include <cmath>
#include <limits>

#include "common/cast/case_set.h"
#include "cpu/exact/arbiter.h"
#include "experiments/cast/judge.h"
#include "experiments/cast/tally.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

ExactHit exactHit(Clarity clarity = Clarity::clean) {
  ExactHit exact;
  exact.primitive = 0;
  exact.clarity = clarity;
  exact.t = 2.0;
  exact.tUnit = 0x1p-23;
  exact.normal = {0.0, 1.0, 0.0};
  return exact;
}

CastHit rightAnswer() {
  return {2.0f, 0, {0.0f, 1.0f, 0.0f}};
}

Finding findingOf(const ExactHit& exact, const CastHit& answer) {
  return judgeHit(exact, answer, 2, false).finding;
}

}  // namespace

TEST_CASE("judgeHit finds NaN and primitives that don't exist, excusing nothing", "[cast]") {
  CastHit nanDistance = rightAnswer();
  nanDistance.t = kNan;
  CastHit nanNormal = rightAnswer();
  nanNormal.normal.z = kNan;
  CastHit beyond = rightAnswer();
  beyond.primitive = 2;
  for (const CastHit& answer : {nanDistance, nanNormal, beyond}) {
    const Judgement judgement = judgeHit(exactHit(Clarity::ambiguous), answer, 2, false);
    CHECK(judgement.finding == Finding::notANumber);
    CHECK(judgement.counts);
  }
}

TEST_CASE("judgeHit names misses, hits and primitives that are wrong", "[cast]") {
  ExactHit miss = exactHit();
  miss.primitive = -1;
  CastHit other = rightAnswer();
  other.primitive = 1;
  CHECK(findingOf(miss, CastHit{}) == Finding::agrees);
  CHECK(findingOf(miss, rightAnswer()) == Finding::falseHit);
  CHECK(findingOf(exactHit(), CastHit{}) == Finding::falseMiss);
  CHECK(findingOf(exactHit(), other) == Finding::wrongPrimitive);
  CHECK(findingOf(exactHit(), rightAnswer()) == Finding::agrees);
}

TEST_CASE("judgeHit measures t in units of the surface's motion and in ulp", "[cast]") {
  CastHit late = rightAnswer();
  late.t = 2.0f + 2 * 0x1p-22f;
  const Judgement judgement = judgeHit(exactHit(), late, 2, false);
  CHECK(judgement.finding == Finding::agrees);
  CHECK(judgement.distanceError == 4.0);
  CHECK(judgement.ulp == 2);
  late.t = 2.0f + 3 * 0x1p-22f;
  CHECK(findingOf(exactHit(), late) == Finding::wrongDistance);
}

TEST_CASE("judgeHit's unit on a sphere is what moving its surface does, up to its rim", "[cast]") {
  constexpr double kUlp = 4 * 0x1p-23;  // of M = 4, the origin's distance
  for (const bool inside : {false, true}) {
    for (const float aside : {0.0f, 0.6f, 0.96f, 0.9999f}) {
      const CastRay ray{{aside, inside ? 0.0f : -4.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.0f, 9.0f};
      CaseSet cases;
      cases.primitives = {CasePrimitive{CaseKind::sphere, {0.0f, 0.0f, 0.0f, 1.0f}}};
      cases.scenes = {{0, 1}};
      cases.rays = {{ray, 0}};
      const ExactHit exact = arbitrate(cases).at(0);
      REQUIRE(exact.leaving == inside);
      // From inside no coordinate exceeds 1.
      const double ulp = inside ? kUlp / 4 : kUlp;
      for (const int moves : {-6, -4, 4, 6}) {
        const double radius = 1.0 + moves * ulp;
        const double chord = std::sqrt((radius - aside) * (radius + double(aside)));
        CastHit answer;
        answer.t = static_cast<float>(inside ? chord : 4.0 - chord);
        answer.primitive = 0;
        answer.normal = glm::vec3(exact.normal);
        INFO("aside " << aside << ", inside " << inside << ", moves " << moves);
        const Judgement judgement = judgeHit(exact, answer, 1, false);
        CHECK((judgement.finding == Finding::wrongDistance) == (std::abs(moves) == 6));
      }
    }
  }
}

TEST_CASE("judgeHit's unit at a tangent is finite: t moves as the root of the surface", "[cast]") {
  const CastRay ray{{1.0f, -4.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.0f, 9.0f};
  CaseSet cases;
  cases.primitives = {CasePrimitive{CaseKind::sphere, {0.0f, 0.0f, 0.0f, 1.0f}}};
  cases.scenes = {{0, 1}};
  cases.rays = {{ray, 0}};
  const ExactHit exact = arbitrate(cases).at(0);
  REQUIRE(exact.t == 4.0);
  for (const int moves : {20, 30}) {  // of which 25 are 5 units
    const double radius = 1.0 + moves * 4 * 0x1p-23;
    CastHit answer;
    answer.t = static_cast<float>(4.0 - std::sqrt(radius * radius - 1.0));
    answer.primitive = 0;
    answer.normal = glm::vec3(exact.normal);
    INFO(moves);
    const Judgement judgement = judgeHit(exact, answer, 1, false);
    CHECK((judgement.finding == Finding::wrongDistance) == (moves > 25));
  }
}

TEST_CASE("judgeHit takes the distance of either face at an edge", "[cast]") {
  ExactHit edge = exactHit();
  edge.facesBeside = {{2.0 + 30 * 0x1p-22, 0x1p-23, {1.0, 0.0, 0.0}}};
  CastHit late = rightAnswer();
  late.t = 2.0f + 32 * 0x1p-22f;
  CHECK(findingOf(edge, late) == Finding::agrees);
  CHECK(judgeHit(edge, late, 2, false).distanceError == 64.0);
  for (const int ulps : {20, 33}) {
    late.t = 2.0f + static_cast<float>(ulps) * 0x1p-22f;
    CHECK(findingOf(edge, late) == Finding::wrongDistance);
  }
}

TEST_CASE("judgeHit takes a t that is a denormal number for zero", "[cast]") {
  ExactHit close = exactHit();
  close.t = 1e-38;
  close.tUnit = 1e-43;
  CastHit answer = rightAnswer();
  for (const float t : {0.0f, 1e-38f}) {
    answer.t = t;
    CHECK(findingOf(close, answer) == Finding::agrees);
  }
  answer.t = 1.3e-38f;
  CHECK(findingOf(close, answer) == Finding::wrongDistance);
  close.t = 1.3e-38;
  answer.t = 0.0f;
  CHECK(findingOf(close, answer) == Finding::wrongDistance);
}

TEST_CASE("judgeHit takes the normal of either face at an edge", "[cast]") {
  ExactHit edge = exactHit();
  edge.facesBeside = {{2.0, 0x1p-23, {1.0, 0.0, 0.0}}};
  CastHit answer = rightAnswer();
  CHECK(findingOf(edge, answer) == Finding::agrees);
  answer.normal = {1.0f, 0.0f, 0.0f};
  CHECK(findingOf(edge, answer) == Finding::agrees);
  for (const glm::vec3 normal : {glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(-1.0f, 0.0f, 0.0f),
                                 glm::vec3(0.7071f, 0.7071f, 0.0f)}) {
    answer.normal = normal;
    CHECK(findingOf(edge, answer) == Finding::wrongNormal);
  }
}

TEST_CASE("judgeHit finds normals that are off, opposite or zero", "[cast]") {
  CastHit answer = rightAnswer();
  answer.normal = {0.0009f, 1.0f, 0.0f};
  CHECK(findingOf(exactHit(), answer) == Finding::agrees);
  for (const glm::vec3 normal : {glm::vec3(0.0011f, 1.0f, 0.0f), glm::vec3(0.0f, -1.0f, 0.0f),
                                 glm::vec3(1.0f, 0.0f, 0.0f)}) {
    answer.normal = normal;
    CHECK(findingOf(exactHit(), answer) == Finding::wrongNormal);
  }
}

TEST_CASE("judgeHit excuses what is ambiguous or a tie, but no gap in a closed surface", "[cast]") {
  for (const Clarity clarity : {Clarity::ambiguous, Clarity::tie}) {
    CHECK_FALSE(judgeHit(exactHit(clarity), CastHit{}, 1, false).counts);
    CHECK(judgeHit(exactHit(clarity), CastHit{}, 1, true).counts);
  }
  CHECK(judgeHit(exactHit(), CastHit{}, 1, false).counts);
}

TEST_CASE("judgeBounce tells self-hits, leaks and rays that never started", "[cast]") {
  const auto judged = [](std::int32_t primitive, Expectation expectation) {
    CastHit answer = rightAnswer();
    answer.primitive = primitive;
    const CastRay upward{{0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    return judgeBounce(answer, upward, expectation).finding;
  };
  CHECK(judged(-1, Expectation::escape) == Finding::agrees);
  CHECK(judged(0, Expectation::escape) == Finding::selfHit);
  CHECK(judged(1, Expectation::plate) == Finding::agrees);
  CHECK(judged(0, Expectation::plate) == Finding::selfHit);
  CHECK(judged(-1, Expectation::plate) == Finding::leak);
  CHECK(judged(kBounceNotStarted, Expectation::plate) == Finding::notStarted);
  const CastRay downward{{0.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}};
  CastHit fromWithin = rightAnswer();
  fromWithin.primitive = 1;
  CHECK(judgeBounce(fromWithin, downward, Expectation::plate).finding == Finding::leak);
}

TEST_CASE("sameAnswer compares bits, but not those of misses nor the sign of zero", "[cast]") {
  CastHit a = rightAnswer();
  CastHit b = rightAnswer();
  b.normal.x = -0.0f;
  CHECK(sameAnswer(a, b));
  b.t = std::nextafter(2.0f, 3.0f);
  CHECK_FALSE(sameAnswer(a, b));
  a.primitive = b.primitive = -1;
  CHECK(sameAnswer(a, b));
}

TEST_CASE("Tally counts clean rays apart and takes quantiles of them", "[cast]") {
  Tally tally;
  for (int i = 1; i <= 1001; ++i) {
    Judgement judgement;
    judgement.comparable = true;
    judgement.counts = i <= 501;
    judgement.distanceError = i;
    judgement.ulp = static_cast<std::uint32_t>(i);
    tally.add(judgement);
  }
  CHECK(tally.all().rays == 1001);
  CHECK(tally.clean().rays == 501);
  CHECK(tally.distanceErrors(false).most == 1001.0);
  CHECK(tally.distanceErrors(false).usual == 1000.0);
  CHECK(tally.ulps(true).most == 501.0);
  CHECK(tally.inexcusable() == 0);
}

TEST_CASE("Tally holds a wrong normal or NaN of a clean ray inexcusable", "[cast]") {
  Tally tally;
  CastHit tilted = rightAnswer();
  tilted.normal = {1.0f, 0.0f, 0.0f};
  tally.add(judgeHit(exactHit(Clarity::ambiguous), tilted, 1, false));
  CHECK(tally.inexcusable() == 0);
  tally.add(judgeHit(exactHit(), tilted, 1, false));
  CHECK(tally.inexcusable() == 1);
  tilted.t = kNan;
  tally.add(judgeHit(exactHit(Clarity::ambiguous), tilted, 1, false));
  CHECK(tally.inexcusable() == 2);
}

}  // namespace twintrace
