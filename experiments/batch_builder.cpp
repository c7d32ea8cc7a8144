#include "experiments/batch_builder.h"

#include <algorithm>

#include "common/stats/family_test.h"

namespace twintrace {

static_assert(BatchBuilder::kFewest == kMinBatchCount);

void BatchBuilder::addFrame(std::span<const float> sums, int passes) {
  for (std::size_t i = 0; i < sums.size(); ++i) sum_.rgb[i] += sums[i];
  if (++framesInSum_ < framesPerBatch_) return;
  const float samples = static_cast<float>(framesInSum_) * static_cast<float>(passes);
  for (float& value : sum_.rgb) value /= samples;
  means_.add(sum_);
  std::fill(sum_.rgb.begin(), sum_.rgb.end(), 0.0f);
  framesInSum_ = 0;
  if (means_.batchCount() < 2 * kFewest) return;
  means_.joinNeighbours();
  framesPerBatch_ *= 2;
}

}  // namespace twintrace
