#include "experiments/explain/explanation.h"

#include "tests/catch.h"
#include "tests/unit/experiments/explain/explain_fixtures.h"

namespace twintrace::test {
namespace {

/// GLSL text that returns `result` one ulp larger.
const std::string kNextFloat = "return intBitsToFloat(floatBitsToInt(result) + 1);";

/// Which of 5 columns of pixels a fault is planted in.
enum class Fault { otherLobe, lightLeak, nan };

/// Shaders with all of the faults, each in its columns: programs take long to compile.
std::vector<ShaderReplacement> faultyShaders() {
  return {changedShader("number.glsl", "#pragma once", "#pragma once\nint plantedFault;"),
          changedShader("path_state.glsl", "SampleKey key = makeSampleKey(",
                        "plantedFault = x / 5;\n  SampleKey key = makeSampleKey("),
          changedShader("material.glsl", "lobeChoice < material.specularChance",
                        "(lobeChoice < material.specularChance) != (plantedFault == 0)"),
          changedShader("light.glsl", "distance * (1.0f - kShadowGap)",
                        "distance * (plantedFault == 1 ? 0.01f : 1.0f - kShadowGap)"),
          changedShader("vertex.glsl", "precise vec3 lit = vertex.radiance + throughput * light;",
                        "precise vec3 lit = vertex.radiance + throughput * light;\n"
                        "if (plantedFault == 2) lit.y = intBitsToFloat(0x7fc00000);")};
}

/// The ball, sound on the CPU, with the faults on the GPU.
struct FaultyColumns {
  SmallScene scene{kBallScene};
  std::unique_ptr<PathTracer> sound = scene.cpu(TraceDetail::calls);
  std::unique_ptr<PathTracer> faulty = scene.gpu(faultyShaders(), TraceDetail::calls);

  /// The first sample whose radiance shows the fault; nothing if there is none.
  std::unique_ptr<SampleExplanation> first(Fault fault, bool reversed = false) const {
    for (int at = 0; at < 5 * 16; ++at) {
      const PixelPosition pixel{5 * static_cast<int>(fault) + at % 5, at / 5};
      auto result = std::make_unique<SampleExplanation>();
      explainSample(reversed ? *faulty : *sound, reversed ? *sound : *faulty, pixel, 0, *result);
      if (!result->sameRadiance) return result;
    }
    return nullptr;
  }
};

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

TEST_CASE("explainSample sees another lobe", "[explain][gl]") {
  const FaultyColumns scene;
  const auto found = scene.first(Fault::otherLobe);
  REQUIRE(found);
  CHECK(culprit(*found) == "sampleScattering");
  CHECK(className(found->kind) == "lobe_flip");
  const auto parted = static_cast<std::size_t>(found->parted);
  CHECK(found->verticesA[parted].lobe != found->verticesB[parted].lobe);
}

TEST_CASE("explainSample sees light that leaks through what stands in its way", "[explain][gl]") {
  const FaultyColumns scene;
  const auto found = scene.first(Fault::lightLeak);
  REQUIRE(found);
  CHECK(culprit(*found) == "shadowReach");
  CHECK(className(found->kind) == "light_leak");
  const auto parted = static_cast<std::size_t>(found->parted);
  CHECK(found->verticesA[parted].blocked == std::vector<bool>{true});
  CHECK(found->verticesB[parted].blocked == std::vector<bool>{false});
}

TEST_CASE("explainSample sees a NaN and where it was born", "[explain][gl]") {
  const FaultyColumns scene;
  const auto found = scene.first(Fault::nan);
  REQUIRE(found);
  CHECK(culprit(*found) == "withLight");
  CHECK(className(found->kind) == "nan");
  // Whichever arm has it.
  const auto reversed = scene.first(Fault::nan, true);
  REQUIRE(reversed);
  CHECK(className(reversed->kind) == "nan");
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
