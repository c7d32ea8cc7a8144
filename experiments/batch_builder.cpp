#include "experiments/batch_builder.h"

#include <algorithm>

#include "common/film/exact_sum.h"
#include "common/stats/family_test.h"

namespace twintrace {

static_assert(BatchBuilder::kFewest == kMinBatchCount);

void BatchBuilder::addFrame(std::span<const float> sums, int passes) {
  for (std::size_t pixel = 0; pixel < goodFrames_.size(); ++pixel) addPixel(sums, pixel);
  if (++framesInSum_ < framesPerBatch_) return;
  endBatch(passes);
  if (means_.batchCount() < 2 * kFewest) return;
  means_.joinNeighbours();
  framesPerBatch_ *= 2;
}

void BatchBuilder::addPixel(std::span<const float> sums, std::size_t pixel) {
  const std::span<const float> value = sums.subspan(pixel * 3, 3);
  if (!std::all_of(value.begin(), value.end(), inSumRange)) {
    ++droppedFrames_;
    return;
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    sum_.rgb[pixel * 3 + channel] += value[channel];
  }
  ++goodFrames_[pixel];
}

/// A pixel without any good frame becomes 0 / 0 = NaN, which the means leave out.
void BatchBuilder::endBatch(int passes) {
  for (std::size_t i = 0; i < sum_.rgb.size(); ++i) {
    sum_.rgb[i] /= static_cast<float>(goodFrames_[i / 3]) * static_cast<float>(passes);
  }
  means_.add(sum_);
  std::fill(sum_.rgb.begin(), sum_.rgb.end(), 0.0f);
  std::fill(goodFrames_.begin(), goodFrames_.end(), 0);
  framesInSum_ = 0;
}

}  // namespace twintrace
