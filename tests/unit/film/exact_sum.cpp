#include "common/film/exact_sum.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/catch.h"

using namespace twintrace;

namespace {

ChannelSum sumOf(const std::vector<float>& values) {
  ChannelSum sums;
  for (const float value : values) sums.add(value);
  return sums;
}

constexpr Int128 kOne = Int128{1} << kSumFraction;
constexpr Uint128 kSquareOne = Uint128{1} << kSquareFraction;

}  // namespace

TEST_CASE("inSumRange takes finite values below 2^30 only", "[film]") {
  const float limit = 1073741824.0f;
  for (const float sign : {1.0f, -1.0f}) {
    CHECK(inSumRange(sign * 0.0f));
    CHECK(inSumRange(sign * std::numeric_limits<float>::denorm_min()));
    CHECK(inSumRange(sign * std::nextafter(limit, 0.0f)));
    CHECK_FALSE(inSumRange(sign * limit));
    CHECK_FALSE(inSumRange(sign * std::numeric_limits<float>::max()));
    CHECK_FALSE(inSumRange(sign * std::numeric_limits<float>::infinity()));
    CHECK_FALSE(inSumRange(sign * std::numeric_limits<float>::quiet_NaN()));
  }
}

TEST_CASE("ChannelSum puts values on its grid exactly", "[film]") {
  CHECK(sumOf({1.0f}).sum == kOne);
  CHECK(sumOf({-1.0f}).sum == -kOne);
  CHECK(sumOf({-0.0f}).sum == 0);
  CHECK(sumOf({0.75f}).sum == kOne / 4 * 3);
  CHECK(sumOf({1073741760.0f}).sum == kOne * 1073741760);
  CHECK(sumOf({0x1p-64f}).sum == 1);
  CHECK(sumOf({-0x1.fffffep-41f}).sum == -((Int128{1} << 24) - 1));
}

TEST_CASE("ChannelSum squares values exactly where the grid allows", "[film]") {
  CHECK(sumOf({-3.0f}).squares == kSquareOne * 9);
  CHECK(sumOf({0x1p-22f}).squares == 1);
  const std::uint64_t largest = 1073741760;
  CHECK(sumOf({1073741760.0f}).squares == kSquareOne * largest * largest);
}

TEST_CASE("ChannelSum rounds below the grid to nearest, ties to even", "[film]") {
  CHECK(sumOf({0x1p-65f}).sum == 0);    // tie between 0 and 1
  CHECK(sumOf({0x1.8p-64f}).sum == 2);  // tie between 1 and 2
  CHECK(sumOf({0x1.4p-63f}).sum == 2);  // tie between 2 and 3
  CHECK(sumOf({-0x1.8p-64f}).sum == -2);
  CHECK(sumOf({0x1.000002p-65f}).sum == 1);  // just above the tie
  CHECK(sumOf({std::numeric_limits<float>::denorm_min()}).sum == 0);
  CHECK(sumOf({std::numeric_limits<float>::min()}).squares == 0);
  CHECK(sumOf({0x1.8p-22f}).squares == 2);  // 2.25
}

TEST_CASE("ChannelSum agrees with long double on random values", "[film]") {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::uint32_t> bits(0u, (157u << 23) - 1u);
  for (int i = 0; i < 100000; ++i) {
    const float value = std::bit_cast<float>(bits(random) | (i % 2 == 0 ? 0u : 0x80000000u));
    const long double exact = value;
    const ChannelSum sums = sumOf({value});
    // 64 mantissa bits hold a float's 24 and its square's 48, so only rintl rounds.
    INFO("value " << std::hexfloat << value);
    REQUIRE(static_cast<long double>(sums.sum) == std::rint(std::ldexp(exact, kSumFraction)));
    REQUIRE(static_cast<long double>(sums.squares) ==
            std::rint(std::ldexp(exact * exact, kSquareFraction)));
  }
}

TEST_CASE("ChannelSum holds the largest sums that a film allows", "[film]") {
  const float largest = std::nextafter(1073741824.0f, 0.0f);
  ChannelSum sums = sumOf({largest});
  for (int i = 0; i < 24; ++i) sums.merge(sums);  // 2^24 values
  CHECK(meanOf(sums, kMaxFrames) == double(largest));
  CHECK(varianceOf(sums, kMaxFrames) == 0.0);
  ChannelSum negative = sumOf({-largest});
  for (int i = 0; i < 24; ++i) negative.merge(negative);
  CHECK(meanOf(negative, kMaxFrames) == -double(largest));
}

TEST_CASE("varianceOf is the sample variance", "[film]") {
  CHECK(varianceOf(sumOf({}), 0) == 0.0);
  CHECK(varianceOf(sumOf({5.0f}), 1) == 0.0);
  CHECK(varianceOf(sumOf({1.0f, 3.0f}), 2) == 2.0);
  CHECK(varianceOf(sumOf({-1.0f, 0.0f, 1.0f}), 3) == 1.0);
  CHECK(varianceOf(sumOf({0.25f, 1.0f}), 2) == 0.28125);  // 2.125 - 1.5625 borrows from the whole
}

TEST_CASE("varianceOf loses nothing to cancellation on a large mean", "[film]") {
  const std::vector<float> values = {1048576.0f, 1048576.125f, 1048576.0f, 1048576.125f};
  CHECK(varianceOf(sumOf(values), 4) == 0.0625 * 0.0625 * 4 / 3);
}

TEST_CASE("varianceOf of equal values is at most the grid of the squares", "[film]") {
  for (const float value : {0.3f, 0.7f, 1e-3f, 17.1f}) {
    CHECK(varianceOf(sumOf({value, value, value}), 3) <= 0x1p-44);
  }
}
