#pragma once

#include <span>

#include "common/film/image.h"
#include "common/stats/batch_means.h"

namespace twintrace {

/// Cuts the frames of a run into batches of equal length for the unpaired tests, however many
/// frames there will be: when twice the fewest batches are there, neighbours are joined. Keeps
/// block means only, so memory does not grow with the number of frames.
class BatchBuilder {
 public:
  BatchBuilder(int width, int height) : means_(width, height), sum_(width, height) {}

  /// Adds the next frame: width * height * 3 sums of `passes` samples.
  void addFrame(std::span<const float> sums, int passes);

  /// Whether no frame is left over and there are enough batches for the tests.
  bool complete() const { return framesInSum_ == 0 && means_.batchCount() >= kFewest; }

  const BatchMeans& means() const { return means_; }

  static constexpr std::size_t kFewest = 32;  ///< kMinBatchCount of family_test.h

 private:
  BatchMeans means_;
  Image sum_;
  int framesInSum_ = 0;
  int framesPerBatch_ = 1;
};

}  // namespace twintrace
