#include "cpu/kernel/corrected.h"

#include <cmath>
#include <random>

#include "common/base/flush_denormals.h"
#include "tests/catch.h"

using namespace twintrace;

namespace {

// Differences from the exact answer that a device's guess may have, in ulp. Its own contract allows
// more than the 2.5 of the GLSL specification.
constexpr int kPerturbations[] = {-4, -2, -1, 0, 1, 2, 4};

constexpr float kSpecial[] = {
    0.0f,    -0.0f,   1e-40f,        -1e-45f,         0x1p-126f, -0x1p-126f, 0x1.fffffep-127f,
    1.0f,    -1.0f,   0x1.fffffep0f, 0x1.000002p0f,   0.5f,      3.0f,       -3.0f,
    0x1p63f, 0x1p-64f, 0x1p127f,     0x1.fffffep127f, -0x1.fffffep127f, INFINITY, -INFINITY, NAN};

float perturbed(float x, int ulps) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + static_cast<std::uint32_t>(ulps));
}

bool same(float a, float b) { return std::isnan(a) ? std::isnan(b) : std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

float refined(float a, float b, int ulps) {
  const float guess = kernel::unitMantissa(a) / kernel::unitMantissa(b);
  return kernel::refinedQuotient(a, b, perturbed(guess, ulps));
}

float refined(float x, int ulps) {
  return kernel::refinedRoot(x, perturbed(std::sqrt(kernel::rootMantissa(x)), ulps));
}

float anyFloat(std::mt19937& random) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(random()));
}

std::string shown(float x) { return std::to_string(std::bit_cast<std::uint32_t>(x)); }

}  // namespace

TEST_CASE("correctedQuotient is the processor's division for special operands", "[unit]") {
  const FlushDenormals flush;
  for (const float a : kSpecial) {
    for (const float b : kSpecial) {
      INFO("bits " << shown(a) << " / " << shown(b));
      CHECK(same(kernel::correctedQuotient(a, b), a / b));
    }
  }
}

TEST_CASE("refinedQuotient is the processor's division for any operands and guesses", "[unit]") {
  const FlushDenormals flush;
  std::mt19937 random(1);
  std::size_t wrong = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float a = anyFloat(random);
    const float b = anyFloat(random);
    for (const int ulps : kPerturbations) wrong += same(refined(a, b, ulps), a / b) ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("refinedQuotient rounds quotients next to midpoints", "[unit]") {
  const FlushDenormals flush;
  std::mt19937 random(2);
  std::size_t wrong = 0;
  for (int i = 0; i < 2000000; ++i) {
    const std::uint64_t half = 0x1000001u + 2u * (random() & 0x7fffffu);  // quotient in half ulp
    const std::uint32_t divisor = 0x800000u | (random() & 0x7fffffu);
    const auto b = static_cast<float>(divisor);
    const float a = static_cast<float>(half * divisor) * 0x1p-24f;  // rounded: just off the midpoint
    for (const int ulps : {-2, 0, 2}) wrong += same(refined(a, b, ulps), a / b) ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("correctedRoot is the processor's root for special operands", "[unit]") {
  const FlushDenormals flush;
  for (const float x : kSpecial) {
    INFO("bits " << shown(x));
    CHECK(same(kernel::correctedRoot(x), std::sqrt(x)));
  }
}

TEST_CASE("refinedRoot is the processor's root for every mantissa of two exponents", "[unit]") {
  const FlushDenormals flush;
  std::size_t wrong = 0;
  for (std::uint32_t bits = 0x3f800000u; bits < 0x40800000u; ++bits) {
    const auto x = std::bit_cast<float>(bits);
    for (const int ulps : {-2, 2}) wrong += same(refined(x, ulps), std::sqrt(x)) ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("refinedRoot is the processor's root for any operands and guesses", "[unit]") {
  const FlushDenormals flush;
  std::mt19937 random(3);
  std::size_t wrong = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float x = anyFloat(random);
    for (const int ulps : kPerturbations) wrong += same(refined(x, ulps), std::sqrt(x)) ? 0 : 1;
  }
  CHECK(wrong == 0);
}
