#include "experiments/explain/explanation.h"

#include "tests/catch.h"
#include "tests/unit/experiments/explain/explain_fixtures.h"

namespace twintrace::test {
namespace {

/// GLSL text that returns `result` one ulp larger.
const std::string kNextFloat = "return intBitsToFloat(floatBitsToInt(result) + 1);";

}  // namespace

TEST_CASE("explainSample finds nothing between arms that agree", "[explain][gl]") {
  const SmallScene scene("local-lights.toml");
  const auto a = scene.cpu();
  const auto b = scene.gpu();
  for (int x = 0; x < 16; ++x) {
    SampleExplanation result;
    explainSample(*a, *b, {x, 10}, 3, result);
    INFO("pixel " << x << ",10, culprit " << culprit(result));
    CHECK(result.sameRadiance);
    CHECK_FALSE(result.divergence);
    CHECK(result.parted == -1);
    CHECK_FALSE(result.verticesA.empty());
  }
}

TEST_CASE("explainSample locates one ulp in a function that others call", "[explain][gl]") {
  const SmallScene scene("local-lights.toml");
  const auto changed =
      changedShader("math.glsl", "(a.x * b.x + a.y * b.y) + a.z * b.z;\n  return result;",
                    "(a.x * b.x + a.y * b.y) + a.z * b.z;\n  " + kNextFloat);
  const auto a = scene.cpu();
  const auto b = scene.gpu({changed});
  const auto found = firstDifferent(*a, *b);
  REQUIRE(found);
  CHECK(culprit(*found) == "dot3");
  const auto words = found->wordDifferences();
  REQUIRE(words.size() == 1);
  CHECK(words[0].b - words[0].a == 1);
}

TEST_CASE("explainSample calls a difference of one ulp rounding", "[explain][gl]") {
  const SmallScene scene("cornell.toml");
  const auto changed = changedShader(
      "path.glsl", "return leave(state, vertex, radiance, next.direction, next.weight);",
      "precise vec3 weight = next.weight;\n"
      "weight.x = intBitsToFloat(floatBitsToInt(weight.x) + 1);\n"
      "return leave(state, vertex, radiance, next.direction, weight);");
  const auto a = scene.cpu();
  const auto b = scene.gpu({changed});
  const auto found = firstDifferent(*a, *b);
  REQUIRE(found);
  CHECK(culprit(*found) == "stepPath");
  CHECK(className(found->kind) == "rounding");
}

TEST_CASE("explainSample calls a wrong branch a branch flip", "[explain][gl]") {
  const SmallScene scene("cornell.toml");
  const auto changed = changedShader("path_state.glsl", "select(along > 0.0f, -normal, normal)",
                                     "select(along < 0.0f, -normal, normal)");
  const auto a = scene.cpu();
  const auto b = scene.gpu({changed});
  const auto found = firstDifferent(*a, *b);
  REQUIRE(found);
  CHECK(culprit(*found) == "facingNormal");
  CHECK(className(found->kind) == "branch_flip");
}

TEST_CASE("explainSample sees another primitive", "[explain][gl]") {
  const SmallScene scene("cornell.toml");
  const auto changed =
      changedShader("ray.glsl", "t < best.t || (t == best.t", "t > best.t || (t == best.t");
  const auto a = scene.cpu();
  const auto b = scene.gpu({changed});
  const auto found = firstDifferent(*a, *b);
  REQUIRE(found);
  CHECK(culprit(*found) == "nearer");
  CHECK(className(found->kind) == "other_primitive");
}

TEST_CASE("explainSample compares precisions of the CPU", "[explain]") {
  const SmallScene scene("cornell.toml");
  SmallScene doubles("cornell.toml");
  doubles.options.precision = Precision::float64;
  const auto a = scene.cpu();
  const auto b = doubles.cpu();
  const auto found = firstDifferent(*a, *b);
  REQUIRE(found);
  CHECK(found->divergence);
}

}  // namespace twintrace::test
