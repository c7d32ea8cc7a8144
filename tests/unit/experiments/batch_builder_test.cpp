#include "experiments/batch_builder.h"

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

}  // namespace twintrace
