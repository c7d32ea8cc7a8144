#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/film/image.h"
#include "common/stats/batch_means.h"

namespace twintrace {

/// Cuts the frames of a run into batches of equal length for the unpaired tests, however many
/// frames there will be: when twice the fewest batches are there, neighbours are joined. Keeps
/// block means only, so memory does not grow with the number of frames.
class BatchBuilder {
 public:
  BatchBuilder(int width, int height)
      : means_(width, height), sum_(width, height), goodFrames_(sum_.pixelCount(), 0) {}

  /// Adds the next frame: width * height * 3 sums of `passes` samples. Pixels that a film leaves
  /// out of its sums are left out here as well.
  void addFrame(std::span<const float> sums, int passes);

  /// Whether no frame is left over and there are enough batches for the tests.
  bool complete() const { return framesInSum_ == 0 && means_.batchCount() >= kFewest; }

  const BatchMeans& means() const { return means_; }

  /// Frames that were left out, over all pixels.
  std::uint64_t droppedFrames() const { return droppedFrames_; }

  static constexpr std::size_t kFewest = 32;  ///< kMinBatchCount of family_test.h

 private:
  void addPixel(std::span<const float> sums, std::size_t pixel);
  void endBatch(int passes);

  BatchMeans means_;
  Image sum_;
  std::vector<int> goodFrames_;  ///< in sum_, per pixel
  std::uint64_t droppedFrames_ = 0;
  int framesInSum_ = 0;
  int framesPerBatch_ = 1;
};

}  // namespace twintrace
