#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/film/image.h"

namespace twintrace {

/// Side of the blocks that the family test averages over, pixels.
inline constexpr int kBlockSize = 8;

/// Division of a picture into blocks of 8x8 pixels, row-major; those at the right and lower border
/// may be smaller.
struct BlockGrid {
  int width = 0;
  int height = 0;

  int columns() const { return (width + kBlockSize - 1) / kBlockSize; }
  int rows() const { return (height + kBlockSize - 1) / kBlockSize; }
  std::size_t blockCount() const {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
  }
  std::size_t blockOf(std::size_t pixel) const;
  /// Upper left pixel of a block.
  PixelPosition corner(std::size_t block) const;
  bool operator==(const BlockGrid&) const = default;
};

/// Block means and picture means of independent batches (renderings of the same scene with sample
/// ranges or seeds that don't overlap): what the unpaired tests read.
class BatchMeans {
 public:
  BatchMeans(int width, int height) : grid_{width, height} {}

  /// Adds one batch. Values that are not finite are left out of the means and counted; a block
  /// without any finite value gets the mean NaN. @throws UsageError if the size differs.
  void add(const Image& batch);

  /// Replaces batches 0 and 1, 2 and 3, ... by their means: half as many batches, twice as long. A
  /// mean of NaN stays NaN. There must be an even number of batches.
  void joinNeighbours();

  const BlockGrid& grid() const { return grid_; }
  std::size_t batchCount() const { return imageMeans_.size(); }
  std::uint64_t nonFiniteValues() const { return nonFiniteValues_; }

  /// Block means of one batch: three channels per block.
  std::span<const double> blockMeans(std::size_t batch) const { return blockMeans_[batch]; }

  /// Mean of the whole picture per channel, one batch.
  const std::array<double, 3>& imageMean(std::size_t batch) const { return imageMeans_[batch]; }

 private:
  BlockGrid grid_;
  std::vector<std::vector<double>> blockMeans_;
  std::vector<std::array<double, 3>> imageMeans_;
  std::uint64_t nonFiniteValues_ = 0;
};

}  // namespace twintrace
