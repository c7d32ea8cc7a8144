// How often the unpaired tests see a difference where there is none, on made-up pictures whose
// values are as skewed as those of path tracing, and whether they see one where there is.

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "common/film/film.h"
#include "common/film/image_io.h"
#include "common/stats/distributions.h"
#include "common/stats/equivalence.h"
#include "common/stats/family_test.h"
#include "common/stats/verdict.h"
#include "tests/catch.h"
#include "tests/unit/stats/stats_fixtures.h"

using namespace twintrace;

namespace {

constexpr int kPairs = 1000;
constexpr int kBatches = 32;
constexpr int kWidth = 20;  // 3 x 2 blocks, the border ones partial
constexpr int kHeight = 12;

/// Chance that a sound test fails this calibration; seeds are fixed, so it does so always or never.
constexpr double kCalibrationAlpha = 1e-6;

using Draw = std::function<double(std::mt19937_64&)>;

struct Source {
  std::string name;
  Draw draw;
};

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Distributions of a pixel's batch mean, from harmless to harmful.
std::vector<Source> sources() {
  return {
      {"normal", [](auto& r) { return std::normal_distribution<double>(1.0, 0.3)(r); }},
      {"lognormal, sigma 1",
       [](auto& r) { return std::lognormal_distribution<double>(0.0, 1.0)(r); }},
      {"lognormal, sigma 2.5",
       [](auto& r) { return std::lognormal_distribution<double>(0.0, 2.5)(r); }},
      {"fireflies, 1 in 1000",
       [](auto& r) { return uniform(r) < 1e-3 ? 500.0 : 0.5 + uniform(r); }},
      {"Pareto, exponent 1.2", [](auto& r) { return std::pow(1.0 - uniform(r), -1.0 / 1.2); }},
      {"lit or not, 1 in 128", [](auto& r) { return uniform(r) < 1.0 / 128.0 ? 1.0 : 0.0; }},
  };
}

/// Prints the observed rate and says whether it is compatible with a true rate of at most alpha.
bool withinBound(const std::string& test, const std::string& source, int alarms, double alpha) {
  const double p = binomialUpper(alarms, kPairs, alpha);
  std::printf("%-22s %-22s alpha %-6g false alarms %3d of %d = %.4f, p = %.2g\n", test.c_str(),
              source.c_str(), alpha, alarms, kPairs, double(alarms) / kPairs, p);
  return p > kCalibrationAlpha;
}

BatchMeans batchesOf(const Source& source, std::mt19937_64& random) {
  return test::randomBatches(kWidth, kHeight, kBatches, random, source.draw);
}

/// A rendered picture of `frames` frames, as an EXR file would hold it.
ImageEstimate pictureOf(const Draw& draw, int frames, std::mt19937_64& random) {
  Film film(kWidth, kHeight, {});
  for (int frame = 0; frame < frames; ++frame) {
    film.addFrame(test::randomImage(kWidth, kHeight, random, draw).rgb, 1,
                  static_cast<std::uint32_t>(frame));
  }
  return estimateFrom(exrContent(film), "picture");
}

}  // namespace

TEST_CASE("familyTest on batches keeps its false-alarm rate", "[statistical]") {
  for (const Source& source : sources()) {
    std::mt19937_64 random(20);
    int alarms5 = 0;
    int alarms1 = 0;
    for (int pair = 0; pair < kPairs; ++pair) {
      const BatchMeans a = batchesOf(source, random);
      const BatchMeans b = batchesOf(source, random);
      alarms5 += familyTest(a, b, 0.05).different;
      alarms1 += familyTest(a, b, 0.01).different;
    }
    CHECK(withinBound("family, batches", source.name, alarms5, 0.05));
    CHECK(withinBound("family, batches", source.name, alarms1, 0.01));
  }
}

// Not an A/A pair: only the means are equal. Heavier tails than these exceed alpha, as the
// comment of familyTest says.
TEST_CASE("familyTest bears arms of unequal skewness", "[statistical]") {
  const Source skewed = sources()[1];
  const Source tight{
      "", [](auto& r) { return std::normal_distribution<double>(std::exp(0.5), 0.1)(r); }};
  std::mt19937_64 random(26);
  int alarms = 0;
  for (int pair = 0; pair < kPairs; ++pair) {
    alarms += familyTest(batchesOf(skewed, random), batchesOf(tight, random), 0.05).different;
  }
  CHECK(withinBound("family, unequal arms", skewed.name, alarms, 0.05));
}

TEST_CASE("familyTest on pictures keeps its false-alarm rate", "[statistical]") {
  for (const Source& source : sources()) {
    std::mt19937_64 random(21);
    int alarms5 = 0;
    int alarms1 = 0;
    for (int pair = 0; pair < kPairs; ++pair) {
      const ImageEstimate a = pictureOf(source.draw, 16, random);
      const ImageEstimate b = pictureOf(source.draw, 16, random);
      alarms5 += familyTest(a, b, 0.05).different;
      alarms1 += familyTest(a, b, 0.01).different;
    }
    CHECK(withinBound("family, pictures", source.name, alarms5, 0.05));
    CHECK(withinBound("family, pictures", source.name, alarms1, 0.01));
  }
}

// The null hypothesis of an equivalence test is a difference: a false alarm is to call means equal
// that are a whole bound apart.
TEST_CASE("equivalenceTest keeps its error rate at the bound", "[statistical]") {
  constexpr double kBound = 0.1;
  for (const Source& source : {sources()[0], sources()[1]}) {
    std::mt19937_64 random(22);
    int alarms = 0;
    for (int pair = 0; pair < kPairs; ++pair) {
      const BatchMeans b = batchesOf(source, random);
      const Source shifted{"", [&](auto& r) { return (1.0 + kBound) * source.draw(r); }};
      const ChannelMeans a = channelMeans(batchesOf(shifted, random));
      alarms += equivalenceTest({a[0], a[0], a[0]},
                                {channelMeans(b)[0], channelMeans(b)[0], channelMeans(b)[0]},
                                kBound, 0.05)
                    .equivalent;
    }
    CHECK(withinBound("equivalence", source.name, alarms, 0.05));
  }
}

// Power: batches of 64 x 64 pixels whose values spread by 20 % of their mean, 32 per arm. A block's
// mean then has a standard error of 0.2 / 8 / sqrt(32) = 0.44 %, the difference of two 0.63 %. A
// bias of 5 % in one corner block is 8 standard errors and must be found; one of 1 % of the whole
// picture is below the noise of its blocks, but 13 standard errors of the picture's mean, so that
// the arms can't pass as equivalent.
TEST_CASE("a biased block is found", "[statistical]") {
  std::mt19937_64 random(23);
  const Draw draw = [](auto& r) { return std::normal_distribution<double>(1.0, 0.2)(r); };
  for (int trial = 0; trial < 20; ++trial) {
    const BatchMeans a = test::randomBatches(64, 64, kBatches, random, draw);
    BatchMeans b(64, 64);
    for (int batch = 0; batch < kBatches; ++batch) {
      Image image = test::randomImage(64, 64, random, draw);
      for (std::size_t y = 0; y < 8; ++y) {
        for (std::size_t x = 0; x < 24; ++x) image.rgb[y * 64 * 3 + x] *= 1.05f;
      }
      b.add(image);
    }
    const FamilyTest family = familyTest(a, b, 0.001);
    CHECK(family.different);
    CHECK(family.worstBlock == PixelPosition{0, 0});
  }
}

TEST_CASE("a bias of 1 % is found where blocks are that well known", "[statistical]") {
  std::mt19937_64 random(24);
  for (int trial = 0; trial < 20; ++trial) {
    const auto drawA = [](auto& r) { return std::lognormal_distribution<double>(0.0, 0.04)(r); };
    const auto drawB = [&](auto& r) { return 1.01 * drawA(r); };
    const BatchMeans a = test::randomBatches(64, 64, kBatches, random, drawA);
    const BatchMeans b = test::randomBatches(64, 64, kBatches, random, drawB);
    const FamilyTest family = familyTest(a, b, 0.001);
    CHECK(family.different);
    CHECK(unpairedVerdict(family, equivalenceTest(channelMeans(a), channelMeans(b))) ==
          Verdict::different);
  }
}

TEST_CASE("a bias of 1 % below the noise of blocks does not pass as equivalent", "[statistical]") {
  std::mt19937_64 random(25);
  for (int trial = 0; trial < 20; ++trial) {
    const auto drawA = [](auto& r) { return std::normal_distribution<double>(1.0, 0.2)(r); };
    const auto drawB = [&](auto& r) { return 1.01 * drawA(r); };
    const BatchMeans a = test::randomBatches(64, 64, kBatches, random, drawA);
    const BatchMeans b = test::randomBatches(64, 64, kBatches, random, drawB);
    const BatchMeans other = test::randomBatches(64, 64, kBatches, random, drawA);
    CHECK_FALSE(equivalenceTest(channelMeans(a), channelMeans(b)).equivalent);
    CHECK(equivalenceTest(channelMeans(a), channelMeans(other)).equivalent);
  }
}
