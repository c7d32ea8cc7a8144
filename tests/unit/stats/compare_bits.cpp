#include "common/stats/compare_bits.h"

#include <cmath>
#include <limits>

#include "common/base/error.h"
#include "tests/catch.h"

using namespace twintrace;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image imageOf(int width, int height, float value) {
  Image image(width, height);
  image.rgb.assign(image.rgb.size(), value);
  return image;
}

}  // namespace

TEST_CASE("compareBits takes NaN for NaN and -0 for +0 as equal", "[stats]") {
  Image a = imageOf(2, 1, 0.0f);
  Image b = imageOf(2, 1, -0.0f);
  a.rgb[0] = kNan;
  b.rgb[0] = -std::bit_cast<float>(0x7fc12345u);
  a.rgb[5] = b.rgb[5] = kInfinity;
  const BitComparison result = compareBits(a, b);
  CHECK(result.pixels == 2);
  CHECK(result.differingPixels == 0);
  CHECK(result.maxUlp == 0);
  CHECK(result.ulpHistogram[0] == 6);
  CHECK_FALSE(result.first);
  CHECK(result.nonFiniteValues == 2);
  CHECK(result.rmse == 0.0);
}

TEST_CASE("compareBits finds the first difference in row order", "[stats]") {
  const Image a = imageOf(4, 3, 1.0f);
  Image b = a;
  b.rgb[(2 * 4 + 0) * 3] = 2.0f;
  b.rgb[(1 * 4 + 3) * 3 + 2] = 2.0f;
  const BitComparison result = compareBits(a, b);
  CHECK(result.first == PixelPosition{3, 1});
  CHECK(result.differingPixels == 2);
}

TEST_CASE("compareBits counts distances by powers of two", "[stats]") {
  const Image a = imageOf(2, 1, 1.0f);
  Image b = a;
  b.rgb[0] = std::nextafter(1.0f, 2.0f);
  b.rgb[1] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(1.0f) + 3u);
  b.rgb[2] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(1.0f) + 4u);
  b.rgb[3] = kNan;
  const BitComparison result = compareBits(a, b);
  CHECK(result.ulpHistogram[0] == 2);
  CHECK(result.ulpHistogram[1] == 1);
  CHECK(result.ulpHistogram[2] == 1);
  CHECK(result.ulpHistogram[3] == 1);
  CHECK(result.ulpHistogram[32] == 1);
  CHECK(result.maxUlp == 0xffffffffu);
}

TEST_CASE("compareBits measures errors with b as the reference", "[stats]") {
  const Image a = imageOf(3, 2, 3.0f);
  const Image b = imageOf(3, 2, 1.0f);
  const BitComparison result = compareBits(a, b);
  CHECK(result.rmse == 2.0);
  CHECK(result.relmse == Approx(4.0 / 1.01));
  CHECK(result.meanA == std::array<double, 3>{3.0, 3.0, 3.0});
  CHECK(result.meanB == std::array<double, 3>{1.0, 1.0, 1.0});
}

TEST_CASE("compareBits knows no mean where no value is finite", "[stats]") {
  Image a = imageOf(2, 1, 1.0f);
  a.rgb[0] = kNan;
  a.rgb[3] = kInfinity;
  const BitComparison result = compareBits(a, a);
  CHECK(std::isnan(result.meanA[0]));
  CHECK(std::isnan(result.meanB[0]));
  CHECK(result.meanA[1] == 1.0);
}

TEST_CASE("compareBits refuses pictures of different sizes", "[stats]") {
  CHECK_THROWS_AS(compareBits(Image(2, 3), Image(3, 2)), UsageError);
  CHECK_THROWS_AS(compareBits(Image(), Image()), UsageError);
}

TEST_CASE("ulpMap holds the largest distance of each pixel", "[stats]") {
  const Image a = imageOf(2, 1, 1.0f);
  Image b = a;
  b.rgb[4] = std::nextafter(1.0f, 2.0f);
  CHECK(ulpMap(a, b) == std::vector<float>{0.0f, 1.0f});
}
