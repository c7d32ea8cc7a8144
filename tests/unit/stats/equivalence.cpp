#include "common/stats/equivalence.h"

#include <cmath>
#include <limits>

#include "common/base/error.h"
#include "common/stats/distributions.h"
#include "tests/catch.h"
#include "tests/unit/stats/stats_fixtures.h"

using namespace twintrace;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ChannelMeans allChannels(double mean, double error, double dof = kInfinity) {
  const MeanEstimate estimate{mean, error, dof};
  return {estimate, estimate, estimate};
}

}  // namespace

TEST_CASE("equivalenceTest is exact without errors", "[stats]") {
  CHECK(equivalenceTest(allChannels(0, 0), allChannels(0, 0)).equivalent);
  CHECK_FALSE(equivalenceTest(allChannels(1e-9, 0), allChannels(0, 0)).equivalent);
  CHECK(equivalenceTest(allChannels(1.004, 0), allChannels(1, 0)).equivalent);
  CHECK_FALSE(equivalenceTest(allChannels(1.006, 0), allChannels(1, 0)).equivalent);
  CHECK_FALSE(equivalenceTest(allChannels(0.994, 0), allChannels(1, 0)).equivalent);
  CHECK(equivalenceTest(allChannels(-1.004, 0), allChannels(-1, 0)).equivalent);
  CHECK_FALSE(equivalenceTest(allChannels(-1, 0), allChannels(1, 0)).equivalent);
}

TEST_CASE("equivalenceTest gives the tail of the nearer bound", "[stats]") {
  const Equivalence result = equivalenceTest(allChannels(1.002, 0.001), allChannels(1, 0));
  CHECK(result.p == Approx(normalTwoSided(3.0) / 2));
  CHECK_FALSE(result.equivalent);
  CHECK(equivalenceTest(allChannels(1.002, 0.001), allChannels(1, 0), 0.01).equivalent);
}

TEST_CASE("equivalenceTest is not passed for want of data", "[stats]") {
  CHECK(equivalenceTest(allChannels(1, 0.1), allChannels(1, 0.1)).p > 0.4);
  CHECK(equivalenceTest(allChannels(1, kInfinity), allChannels(1, 0)).p == 1.0);
  CHECK(equivalenceTest(allChannels(std::nan(""), 0), allChannels(1, 0)).p == 1.0);
}

TEST_CASE("equivalenceTest needs every channel", "[stats]") {
  ChannelMeans a = allChannels(1, 0.0001);
  a[1].mean = 1.01;
  const Equivalence result = equivalenceTest(a, allChannels(1, 0));
  CHECK(result.channelP[0] < 1e-6);
  CHECK(result.channelP[1] > 0.999);
  CHECK(result.p == result.channelP[1]);
}

TEST_CASE("equivalenceTest refuses bounds and levels out of range", "[stats]") {
  const ChannelMeans one = allChannels(1, 0);
  CHECK_THROWS_AS(equivalenceTest(one, one, 0.0), UsageError);
  CHECK_THROWS_AS(equivalenceTest(one, one, 0.005, 1.0), UsageError);
}

TEST_CASE("channelMeans of batches and of a picture agree", "[stats]") {
  const ChannelMeans fromBatches = channelMeans(test::constantBatches(9, 9, 32, 0.5f));
  CHECK(fromBatches[2].mean == 0.5);
  CHECK(fromBatches[2].standardError == 0.0);
  Image mean(2, 2);
  Image error(2, 2);
  for (std::size_t i = 0; i < 12; ++i) {
    mean.rgb[i] = i < 6 ? 1.0f : 2.0f;
    error.rgb[i] = 0.5f;
  }
  const ChannelMeans fromPicture = channelMeans(estimateFrom(mean, error));
  CHECK(fromPicture[0].mean == 1.5);
  CHECK(fromPicture[0].standardError == 0.25);
  CHECK(std::isinf(fromPicture[0].dof));
}
