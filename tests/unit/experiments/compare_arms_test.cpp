#include "experiments/compare_arms.h"

#include "common/base/error.h"
#include "tests/catch.h"

namespace twintrace {

TEST_CASE("Arms are paired if seed, noise and samples are equal", "[experiments]") {
  ArmOptions options;
  options.b.backend = BackEnd::gpu;
  options.b.maths = Maths::native;
  CHECK(isPaired(options));
  // 61 and 64 samples are both 4 frames of 16.
  options.a.passes = options.b.passes = 16;
  options.b.spp = 61;
  CHECK(isPaired(options));
}

TEST_CASE("Arms whose frames are summed differently are unpaired, and a note says so",
          "[experiments]") {
  ArmOptions options;
  options.a.spp = options.b.spp = 512;
  options.b.passes = 16;
  CHECK_FALSE(isPaired(options));
  const auto notes = fitForTests(options);
  REQUIRE(notes.size() == 1);
  CHECK(notes[0] ==
        "passes differ (1 and 16): frames are summed differently, so the arms are "
        "tested as unpaired");
}

TEST_CASE("Another seed, noise, first sample or spp makes arms unpaired", "[experiments]") {
  ArmOptions seed, noise, first, spp;
  seed.b.seed = 2;
  noise.b.noise = Noise::sine;
  first.b.firstSample = 64;
  spp.b.spp = 65;
  CHECK_FALSE(isPaired(seed));
  CHECK_FALSE(isPaired(noise));
  CHECK_FALSE(isPaired(first));
  CHECK_FALSE(isPaired(spp));
}

TEST_CASE("fitForTests leaves paired arms and long runs alone", "[experiments]") {
  ArmOptions options;
  options.a.passes = options.b.passes = 16;
  CHECK(fitForTests(options).empty());
  options.b.seed = 2;
  options.a.spp = options.b.spp = 512;
  CHECK(fitForTests(options).empty());
  CHECK(options.a.passes == 16);
}

TEST_CASE("fitForTests lowers passes to a divisor of the first sample", "[experiments]") {
  ArmOptions options;
  options.a.passes = 16;
  options.a.spp = 100;
  options.a.firstSample = 32;
  options.b.seed = 2;
  CHECK(fitForTests(options).size() == 1);
  CHECK(options.a.passes == 2);
  CHECK(options.a.spp == 100);
  CHECK(plannedFrames(options.a) >= 32);
}

TEST_CASE("fitForTests raises spp to 32", "[experiments]") {
  ArmOptions options;
  options.a.spp = 4;
  options.b.seed = 2;
  CHECK(fitForTests(options).size() == 1);
  CHECK(options.a.spp == 32);
  CHECK(options.a.passes == 1);
}

TEST_CASE("checkArms refuses films of unequal sizes", "[experiments]") {
  ArmOptions options;
  options.b.height = 3;
  CHECK_THROWS_AS(checkArms(options), UsageError);
}

}  // namespace twintrace
