#include "common/stats/batch_means.h"

#include <cassert>
#include <cmath>
#include <string>

#include "common/base/error.h"

namespace twintrace {

std::size_t BlockGrid::blockOf(std::size_t pixel) const {
  const std::size_t rowSize = static_cast<std::size_t>(width);
  return pixel / rowSize / kBlockSize * static_cast<std::size_t>(columns()) +
         pixel % rowSize / kBlockSize;
}

PixelPosition BlockGrid::corner(std::size_t block) const {
  const int index = static_cast<int>(block);
  return {index % columns() * kBlockSize, index / columns() * kBlockSize};
}

void BatchMeans::add(const Image& batch) {
  if (batch.width != grid_.width || batch.height != grid_.height) {
    throw UsageError("found a batch of " + std::to_string(batch.width) + "x" +
                     std::to_string(batch.height) + " pixels, expected " +
                     std::to_string(grid_.width) + "x" + std::to_string(grid_.height));
  }
  std::vector<double> means(grid_.blockCount() * 3, 0.0);
  std::vector<int> counts(means.size(), 0);
  std::array<double, 3> total{};
  std::array<double, 3> totalCount{};
  for (std::size_t i = 0; i < batch.rgb.size(); ++i) {
    if (!std::isfinite(batch.rgb[i])) {
      ++nonFiniteValues_;
      continue;
    }
    const std::size_t unit = grid_.blockOf(i / 3) * 3 + i % 3;
    means[unit] += batch.rgb[i];
    ++counts[unit];
    total[i % 3] += batch.rgb[i];
    totalCount[i % 3] += 1.0;
  }
  for (std::size_t unit = 0; unit < means.size(); ++unit) means[unit] /= counts[unit];
  for (std::size_t channel = 0; channel < 3; ++channel) total[channel] /= totalCount[channel];
  blockMeans_.push_back(std::move(means));
  imageMeans_.push_back(total);
}

void BatchMeans::joinNeighbours() {
  assert(batchCount() % 2 == 0);
  const auto join = [](const auto& a, const auto& b) {
    auto mean = a;
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (a[i] + b[i]);
    return mean;
  };
  for (std::size_t batch = 0; batch < batchCount() / 2; ++batch) {
    blockMeans_[batch] = join(blockMeans_[2 * batch], blockMeans_[2 * batch + 1]);
    imageMeans_[batch] = join(imageMeans_[2 * batch], imageMeans_[2 * batch + 1]);
  }
  blockMeans_.resize(batchCount() / 2);
  imageMeans_.resize(blockMeans_.size());
}

}  // namespace twintrace
