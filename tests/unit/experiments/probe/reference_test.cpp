#include "experiments/probe/reference.h"

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/catch.h"

namespace twintrace::probe {
namespace {

std::vector<float> answerOf(const std::string& signature, const std::vector<float>& inputs,
                            std::size_t count = 1) {
  const Reference* reference = referenceOf(signature);
  REQUIRE(reference != nullptr);
  std::vector<float> outputs(count);
  INFO(signature);
  REQUIRE(reference->answer(inputs.data(), outputs.data()));
  return outputs;
}

bool inDomain(const std::string& signature, const std::vector<float>& inputs) {
  float outputs[3];
  return referenceOf(signature)->answer(inputs.data(), outputs);
}

}  // namespace

// Decimals to 12 digits or more, rounded to float by the compiler.
TEST_CASE("references are correctly rounded at known points", "[probe]") {
  CHECK(answerOf("sine(float)", {1.0f})[0] == 0.841470984808f);
  CHECK(answerOf("log2Of(float)", {10.0f})[0] == 3.321928094887f);
  CHECK(answerOf("log2Of(float)", {8.0f})[0] == 3.0f);
  CHECK(answerOf("exp2Of(float)", {0.5f})[0] == 1.414213562373f);
  CHECK(answerOf("power(float, float)", {3.0f, 0.5f})[0] == 1.732050807569f);
  CHECK(answerOf("arcTangent2(float, float)", {1.0f, 2.0f})[0] == 0.463647609001f);
  CHECK(answerOf("arcCosine(float)", {0.5f})[0] == 1.047197551197f);
  CHECK(answerOf("arcCosine(float)", {-1.0f})[0] == 3.141592653590f);
  CHECK(answerOf("squareRoot(float)", {2.0f})[0] == 1.414213562373f);
  CHECK(answerOf("divide(float, float)", {1.0f, 3.0f})[0] == 0.333333333333f);
  CHECK(answerOf("length3(vec3)", {3.0f, 4.0f, 12.0f})[0] == 13.0f);
}

TEST_CASE("turns are exact where sine and cosine are", "[probe]") {
  const std::vector<float> quarter = {1.0f, 0.0f};
  CHECK(answerOf("sinCosTurns(float)", {0.25f}, 2) == quarter);
  const std::vector<float> half = {0.0f, -1.0f};
  CHECK(answerOf("sinCosTurns(float)", {0.5f}, 2) == half);
}

TEST_CASE("quarter turns beside an angle are read as an integer", "[probe]") {
  for (int quarters = -4; quarters <= 4; ++quarters) {
    INFO(quarters);
    const auto both =
        answerOf("sinCosReduced(float, int)", {0.5f, std::bit_cast<float>(quarters)}, 2);
    const double angle = 0.5 + quarters * 1.57079632679489662;
    CHECK(both[0] == static_cast<float>(std::sin(angle)));
    CHECK(both[1] == static_cast<float>(std::cos(angle)));
  }
}

TEST_CASE("sums of products are exact before they are rounded", "[probe]") {
  const float huge = 0x1p30f;
  CHECK(answerOf("dot3(vec3, vec3)", {huge, 3.0f, -huge, huge, 1.0f, huge})[0] == 3.0f);
  const auto cross = answerOf("cross3(vec3, vec3)", {huge, 1.0f, 0.0f, huge, 1.0f, 1.0f}, 3);
  CHECK(cross[0] == 1.0f);
  CHECK(cross[1] == -huge);
  CHECK(cross[2] == 0.0f);
}

TEST_CASE("a reference keeps the sign of what it normalises", "[probe]") {
  const std::vector<float> expected = {0.0f, -0.6f, 0.8f};
  CHECK(answerOf("normalize3(vec3)", {0.0f, -3.0f, 4.0f}, 3) == expected);
}

TEST_CASE("outside the domain there is no reference", "[probe]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float denormal = 1e-40f;
  CHECK_FALSE(inDomain("sine(float)", {nan}));
  CHECK_FALSE(inDomain("sine(float)", {50001.0f}));
  CHECK_FALSE(inDomain("log2Of(float)", {-1.0f}));
  CHECK_FALSE(inDomain("log2Of(float)", {denormal}));
  CHECK_FALSE(inDomain("exp2Of(float)", {128.0f}));
  CHECK_FALSE(inDomain("power(float, float)", {-1.0f, 2.0f}));
  CHECK_FALSE(inDomain("power(float, float)", {10.0f, 100.0f}));
  CHECK_FALSE(inDomain("arcCosine(float)", {1.5f}));
  CHECK_FALSE(inDomain("arcTangent2(float, float)", {0.0f, 0.0f}));
  CHECK_FALSE(inDomain("squareRoot(float)", {-1.0f}));
  CHECK_FALSE(inDomain("normalize3(vec3)", {0.0f, 0.0f, 0.0f}));
  CHECK(referenceOf("pcgHash(uint)") == nullptr);
}

}  // namespace twintrace::probe
