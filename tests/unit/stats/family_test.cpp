#include "common/stats/family_test.h"

#include <cmath>
#include <limits>

#include "common/base/error.h"
#include "common/stats/permutation_test.h"
#include "tests/catch.h"
#include "tests/unit/stats/stats_fixtures.h"

using namespace twintrace;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

double drawNormal(std::mt19937_64& random) {
  return std::normal_distribution<double>(1.0, 0.3)(random);
}

ImageEstimate estimateOf(int width, int height, float mean, float error) {
  Image means(width, height);
  Image errors(width, height);
  means.rgb.assign(means.rgb.size(), mean);
  errors.rgb.assign(errors.rgb.size(), error);
  return estimateFrom(means, errors);
}

}  // namespace

TEST_CASE("familyTest is exact for batches without variance", "[stats]") {
  const BatchMeans a = test::constantBatches(20, 20, 32, 0.3f);
  const FamilyTest same = familyTest(a, test::constantBatches(20, 20, 33, 0.3f), 0.01);
  CHECK_FALSE(same.different);
  CHECK(same.smallestP == 1.0);
  CHECK(same.familySize == 27);
  const float next = std::nextafter(0.3f, 1.0f);
  const FamilyTest other = familyTest(a, test::constantBatches(20, 20, 32, next), 0.01);
  CHECK(other.different);
  CHECK(other.smallestP == 0.0);
  CHECK(other.rejected == 27);
}

TEST_CASE("familyTest finds one shifted block and says which", "[stats]") {
  std::mt19937_64 random(1);
  const BatchMeans a = test::randomBatches(40, 24, 32, random, drawNormal);
  BatchMeans b(40, 24);
  for (int batch = 0; batch < 32; ++batch) {
    Image image = test::randomImage(40, 24, random, drawNormal);
    for (int y = 8; y < 16; ++y) {
      for (int x = 32; x < 40; ++x)
        image.rgb[static_cast<std::size_t>(y * 40 + x) * 3 + 2] += 0.08f;
    }
    b.add(image);
  }
  const FamilyTest result = familyTest(a, b, 0.001);
  CHECK(result.different);
  CHECK(result.rejected == 1);
  CHECK(result.worstBlock == PixelPosition{32, 8});
  CHECK(result.worstChannel == 2);
  CHECK(result.permutationP <= 0.001);
}

TEST_CASE("familyTest does not test blocks without finite values", "[stats]") {
  BatchMeans a(8, 8);
  BatchMeans b(8, 8);
  Image bad(8, 8);
  for (std::size_t i = 0; i < bad.rgb.size(); i += 3) bad.rgb[i] = kInfinity;
  for (int i = 0; i < 32; ++i) {
    a.add(i == 7 ? bad : Image(8, 8));
    b.add(Image(8, 8));
  }
  const FamilyTest result = familyTest(a, b, 0.01);
  CHECK(result.untested == 1);
  CHECK(result.familySize == 2);
  CHECK_FALSE(result.different);
}

TEST_CASE("familyTest refuses too few batches, sizes that differ and a bad alpha", "[stats]") {
  const BatchMeans a = test::constantBatches(8, 8, 32, 1.0f);
  CHECK_THROWS_AS(familyTest(a, test::constantBatches(8, 8, 31, 1.0f), 0.01), UsageError);
  CHECK_THROWS_AS(familyTest(a, test::constantBatches(8, 9, 32, 1.0f), 0.01), UsageError);
  CHECK_THROWS_AS(familyTest(a, a, 0.0), UsageError);
  CHECK_THROWS_AS(familyTest(a, a, 1.0), UsageError);
}

TEST_CASE("familyTest on pictures needs known errors", "[stats]") {
  const ImageEstimate a = estimateOf(8, 8, 1.0f, 0.1f);
  CHECK_FALSE(familyTest(a, estimateOf(8, 8, 1.02f, 0.1f), 0.01).different);
  // 64 pixels: the block's standard error is 0.1 sqrt(2) / 8, so 0.15 is 8.5 of them.
  CHECK(familyTest(a, estimateOf(8, 8, 1.15f, 0.1f), 0.01).different);
  const FamilyTest unknown = familyTest(a, estimateOf(8, 8, 9.0f, kInfinity), 0.01);
  CHECK_FALSE(unknown.different);
  CHECK(unknown.untested == 3);
}

TEST_CASE("familyTest on pictures counts few frames as few degrees of freedom", "[stats]") {
  ImageEstimate a = estimateOf(1, 1, 0.0f, 1.0f);
  ImageEstimate b = estimateOf(1, 1, 7.0f, 1.0f);
  CHECK(familyTest(a, b, 0.001).different);
  a.count = b.count = {3.0f};
  CHECK_FALSE(familyTest(a, b, 0.001).different);
}

TEST_CASE("familyTest on pictures is exact without errors", "[stats]") {
  const ImageEstimate a = estimateOf(9, 3, 0.5f, 0.0f);
  CHECK(familyTest(a, a, 0.01).smallestP == 1.0);
  CHECK(familyTest(a, estimateOf(9, 3, std::nextafter(0.5f, 1.0f), 0.0f), 0.01).different);
}

TEST_CASE("maxTPermutationP does not depend on order or scale of the blocks", "[stats]") {
  std::mt19937_64 random(5);
  const BatchMeans a = test::randomBatches(33, 17, 32, random, drawNormal);
  const BatchMeans b = test::randomBatches(33, 17, 40, random, drawNormal);
  const double p = maxTPermutationP(a, b, 199, 1);
  CHECK(p == maxTPermutationP(a, b, 199, 1));
  CHECK(p > 1.0 / 200.0);
  CHECK(p <= 1.0);
}

TEST_CASE("maxTPermutationP has nothing to say about constant blocks", "[stats]") {
  const BatchMeans a = test::constantBatches(8, 8, 32, 0.1f);
  CHECK(maxTPermutationP(a, a, 99, 1) == 1.0);
  CHECK(maxTPermutationP(a, test::constantBatches(8, 8, 32, 0.2f), 99, 1) == 0.01);
}
