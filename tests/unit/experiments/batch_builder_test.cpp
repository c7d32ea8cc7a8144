#include "experiments/batch_builder.h"

#include <cmath>

#include "tests/catch.h"

namespace twintrace {
namespace {

/// Adds frames 0 .. count - 1 of 2 samples, frame i with the mean i.
void addFrames(BatchBuilder& builder, int count) {
  for (int i = 0; i < count; ++i) {
    const std::vector<float> sums(3, 2.0f * float(i));
    builder.addFrame(sums, 2);
  }
}

}  // namespace

TEST_CASE("BatchBuilder makes each of the first frames a batch", "[experiments]") {
  BatchBuilder builder(1, 1);
  addFrames(builder, 31);
  CHECK_FALSE(builder.complete());
  addFrames(builder, 1);
  CHECK(builder.complete());
  CHECK(builder.means().batchCount() == 32);
  CHECK(builder.means().imageMean(30)[0] == 30.0);
}

TEST_CASE("BatchBuilder keeps 32 to 63 batches of equal length", "[experiments]") {
  BatchBuilder builder(1, 1);
  addFrames(builder, 64);
  CHECK(builder.means().batchCount() == 32);
  CHECK(builder.means().imageMean(0)[0] == 0.5);
  CHECK(builder.means().imageMean(31)[0] == 62.5);
  addFrames(builder, 1);
  CHECK_FALSE(builder.complete());
  addFrames(builder, 1);
  CHECK(builder.complete());
  CHECK(builder.means().batchCount() == 33);
  addFrames(builder, 1000);
  CHECK(builder.means().batchCount() >= 32);
  CHECK(builder.means().batchCount() < 64);
}

TEST_CASE("BatchBuilder leaves out what a film leaves out", "[experiments]") {
  constexpr float kTooLarge = 1073741824.0f;  // 2^30
  BatchBuilder builder(1, 1);
  addFrames(builder, 64);  // from here on batches of two frames
  builder.addFrame(std::vector<float>{6.0f, 6.0f, 6.0f}, 2);
  builder.addFrame(std::vector<float>{8.0f, kTooLarge, 8.0f}, 2);
  REQUIRE(builder.complete());
  CHECK(builder.means().imageMean(32) == std::array<double, 3>{3.0, 3.0, 3.0});
  CHECK(builder.droppedFrames() == 1);
  for (int i = 0; i < 2; ++i) builder.addFrame(std::vector<float>(3, -kTooLarge), 2);
  CHECK(std::isnan(builder.means().imageMean(33)[0]));
  CHECK(builder.droppedFrames() == 3);
}

}  // namespace twintrace
