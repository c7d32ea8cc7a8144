#include "common/stats/permutation_test.h"

#include "common/base/parallel_for.h"
#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <random>
#include <vector>

namespace twintrace {
namespace {

using Labels = std::vector<std::uint32_t>;  // batches that belong to arm a

/// Block-channels handled at once, so that all their batches stay in the second-level cache.
constexpr std::size_t kChunk = 256;

std::vector<Labels> drawLabels(std::size_t countA, std::size_t countAll, int permutations,
                               std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Labels> labels;
  std::vector<std::uint32_t> order(countAll);
  std::iota(order.begin(), order.end(), 0u);
  labels.emplace_back(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(countA));
  for (int i = 0; i < permutations; ++i) {
    // Fisher-Yates by hand: std::shuffle differs between libraries.
    for (std::size_t k = 0; k < countA; ++k)
      std::swap(order[k], order[k + random() % (countAll - k)]);
    labels.emplace_back(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(countA));
  }
  return labels;
}

/// The values of up to kChunk block-channels in all batches of both arms, centred.
class Chunk {
 public:
  Chunk(const BatchMeans& a, const BatchMeans& b, std::size_t first, std::size_t last)
      : size_(last - first),
        countA_(a.batchCount()),
        countB_(b.batchCount()),
        values_(size_ * (countA_ + countB_)),
        squares_(size_, 0.0),
        sumA_(size_),
        squaresA_(size_) {
    for (std::size_t batch = 0; batch < countA_ + countB_; ++batch) {
      const auto means = batch < countA_ ? a.blockMeans(batch) : b.blockMeans(batch - countA_);
      std::copy_n(means.begin() + static_cast<std::ptrdiff_t>(first), size_, row(batch));
    }
    for (std::size_t unit = 0; unit < size_; ++unit) centre(unit);
  }

  /// Largest squared Welch t over the chunk's block-channels for this labelling.
  double maxSquaredT(const Labels& labels) {
    std::fill(sumA_.begin(), sumA_.end(), 0.0);
    std::fill(squaresA_.begin(), squaresA_.end(), 0.0);
    for (const std::uint32_t batch : labels) {
      const double* values = row(batch);
      for (std::size_t unit = 0; unit < size_; ++unit) {
        sumA_[unit] += values[unit];
        squaresA_[unit] += values[unit] * values[unit];
      }
    }
    double largest = 0.0;
    for (std::size_t unit = 0; unit < size_; ++unit) largest = std::max(largest, squaredT(unit));
    return largest;
  }

 private:
  double* row(std::size_t batch) { return values_.data() + batch * size_; }

  /// Subtracts the mean of both arms: t does not change, sums of squares lose no digits, and the
  /// sum over all batches is 0, so that arm b's sum is minus arm a's.
  void centre(std::size_t unit) {
    const std::size_t count = countA_ + countB_;
    double sum = 0.0;
    bool constant = true;
    for (std::size_t batch = 0; batch < count; ++batch) {
      sum += row(batch)[unit];
      constant = constant && row(batch)[unit] == row(0)[unit];
    }
    const double mean = sum / static_cast<double>(count);
    for (std::size_t batch = 0; batch < count; ++batch) {
      double& value = row(batch)[unit];
      value = constant || std::isnan(mean) ? 0.0 : value - mean;
      squares_[unit] += value * value;
    }
  }

  double squaredT(std::size_t unit) const {
    const double countA = static_cast<double>(countA_);
    const double countB = static_cast<double>(countB_);
    const double sumA = sumA_[unit];
    const double difference = sumA / countA + sumA / countB;
    const double spreadA = std::max(0.0, squaresA_[unit] - sumA * sumA / countA);
    const double spreadB = std::max(0.0, squares_[unit] - squaresA_[unit] - sumA * sumA / countB);
    const double error = spreadA / (countA - 1.0) / countA + spreadB / (countB - 1.0) / countB;
    // What is left of the spread of constant arms after cancellation: about 1e-16 of the squares.
    if (error <= 1e-14 * squares_[unit]) {
      return squares_[unit] == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return difference * difference / error;
  }

  std::size_t size_;
  std::size_t countA_;
  std::size_t countB_;
  std::vector<double> values_;
  std::vector<double> squares_;
  std::vector<double> sumA_;
  std::vector<double> squaresA_;
};

}  // namespace

double maxTPermutationP(const BatchMeans& a, const BatchMeans& b, int permutations,
                        std::uint64_t seed) {
  const std::vector<Labels> labels =
      drawLabels(a.batchCount(), a.batchCount() + b.batchCount(), permutations, seed);
  const std::size_t unitCount = a.grid().blockCount() * 3;
  std::vector<double> largest(labels.size(), 0.0);
  std::mutex mutex;
  const tbb::blocked_range<std::size_t> chunks(0, (unitCount + kChunk - 1) / kChunk);
  parallelFor(chunks, [&](const tbb::blocked_range<std::size_t>& range) {
    std::vector<double> local(labels.size(), 0.0);
    for (std::size_t index = range.begin(); index != range.end(); ++index) {
      Chunk chunk(a, b, index * kChunk, std::min(unitCount, (index + 1) * kChunk));
      for (std::size_t i = 0; i < labels.size(); ++i)
        local[i] = std::max(local[i], chunk.maxSquaredT(labels[i]));
    }
    const std::lock_guard lock(mutex);
    for (std::size_t i = 0; i < labels.size(); ++i) largest[i] = std::max(largest[i], local[i]);
  });
  const double observed = largest[0];
  const auto atLeast =
      std::count_if(largest.begin() + 1, largest.end(), [&](double t) { return t >= observed; });
  return static_cast<double>(atLeast + 1) / static_cast<double>(permutations + 1);
}

}  // namespace twintrace
