#include "common/stats/family_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/stats/multiple_testing.h"
#include "common/stats/permutation_test.h"
#include "common/stats/welch.h"

namespace twintrace {
namespace {

/// Smallest level that the confirming test resolves; its 2e5 relabellings of a megapixel are still
/// done in minutes.
constexpr double kSmallestConfirmedAlpha = 1e-5;

/// Any value would do: relabellings only have to be independent of the pictures.
constexpr std::uint64_t kRelabellingSeed = 0x7477696e74726163u;

void requireAlpha(double alpha) {
  if (alpha > 0.0 && alpha < 1.0) return;
  throw UsageError("found alpha " + std::to_string(alpha) + ", expected a number between 0 and 1");
}

void requireBatches(const BatchMeans& a, const BatchMeans& b) {
  if (!(a.grid() == b.grid()))
    throw UsageError("found batches of different sizes, expected equal ones");
  const std::size_t fewest = std::min(a.batchCount(), b.batchCount());
  if (fewest < kMinBatchCount) {
    throw UsageError("found " + std::to_string(fewest) + " batches in an arm, expected at least " +
                     std::to_string(kMinBatchCount));
  }
}

/// Holm over the p-values; NaN marks a block-channel that could not be tested.
FamilyTest judgeFamily(const std::vector<double>& p, const BlockGrid& grid, double alpha) {
  FamilyTest result;
  result.alpha = alpha;
  std::vector<double> tested;
  std::vector<std::size_t> units;
  for (std::size_t unit = 0; unit < p.size(); ++unit) {
    if (std::isnan(p[unit])) continue;
    tested.push_back(p[unit]);
    units.push_back(unit);
  }
  result.familySize = tested.size();
  result.untested = p.size() - tested.size();
  if (tested.empty()) return result;
  const std::vector<double> adjusted = holmAdjusted(tested);
  const auto worst = std::min_element(tested.begin(), tested.end()) - tested.begin();
  const std::size_t worstUnit = units[static_cast<std::size_t>(worst)];
  result.smallestP = adjusted[static_cast<std::size_t>(worst)];
  result.worstBlock = grid.corner(worstUnit / 3);
  result.worstChannel = static_cast<int>(worstUnit % 3);
  result.rejected = static_cast<std::size_t>(std::count_if(
      adjusted.begin(), adjusted.end(), [&](double value) { return value <= alpha; }));
  result.different = result.rejected > 0;
  return result;
}

MeanEstimate unitEstimate(const BatchMeans& arm, std::size_t unit) {
  std::vector<double> values(arm.batchCount());
  for (std::size_t batch = 0; batch < values.size(); ++batch)
    values[batch] = arm.blockMeans(batch)[unit];
  return meanEstimate(values);
}

/// Sums over the pixels of one block-channel of one picture.
struct BlockSums {
  double mean = 0.0;
  double squaredError = 0.0;
  double dofDivisor = 0.0;  ///< sum of squared error^2 / dof, for Satterthwaite's formula
  double pixels = 0.0;

  void add(const ImageEstimate& picture, std::size_t i) {
    const double squared = double(picture.standardError.rgb[i]) * picture.standardError.rgb[i];
    mean += picture.mean.rgb[i];
    squaredError += squared;
    if (!picture.count.empty()) dofDivisor += squared * squared / (picture.count[i / 3] - 1.0);
    pixels += 1.0;
  }

  MeanEstimate estimate() const {
    const double dof = dofDivisor > 0.0 ? squaredError * squaredError / dofDivisor
                                        : std::numeric_limits<double>::infinity();
    return {mean / pixels, std::sqrt(squaredError) / pixels, dof};
  }
};

bool known(const ImageEstimate& picture, std::size_t i) {
  return std::isfinite(picture.mean.rgb[i]) && std::isfinite(picture.standardError.rgb[i]);
}

}  // namespace

FamilyTest familyTest(const BatchMeans& a, const BatchMeans& b, double alpha) {
  requireAlpha(alpha);
  requireBatches(a, b);
  std::vector<double> p(a.grid().blockCount() * 3);
  for (std::size_t unit = 0; unit < p.size(); ++unit) {
    const MeanEstimate meanA = unitEstimate(a, unit);
    const MeanEstimate meanB = unitEstimate(b, unit);
    const bool tested = std::isfinite(meanA.mean) && std::isfinite(meanB.mean);
    p[unit] = tested ? welchTwoSided(meanA, meanB) : std::numeric_limits<double>::quiet_NaN();
  }
  FamilyTest result = judgeFamily(p, a.grid(), alpha);
  if (!result.different) return result;
  // Twice the relabellings that resolve alpha: one of them may reach the observed value by chance.
  const double level = std::max(alpha, kSmallestConfirmedAlpha);
  const int permutations = std::max(1999, static_cast<int>(std::ceil(2.0 / level)) - 1);
  result.permutationP = maxTPermutationP(a, b, permutations, kRelabellingSeed);
  result.different = result.permutationP <= level;
  return result;
}

FamilyTest familyTest(const ImageEstimate& a, const ImageEstimate& b, double alpha) {
  requireAlpha(alpha);
  requireSameSize(a.mean, b.mean);
  const BlockGrid grid{a.mean.width, a.mean.height};
  std::vector<BlockSums> sumsA(grid.blockCount() * 3);
  std::vector<BlockSums> sumsB(grid.blockCount() * 3);
  for (std::size_t i = 0; i < a.mean.rgb.size(); ++i) {
    if (!known(a, i) || !known(b, i)) continue;
    const std::size_t unit = grid.blockOf(i / 3) * 3 + i % 3;
    sumsA[unit].add(a, i);
    sumsB[unit].add(b, i);
  }
  std::vector<double> p(sumsA.size());
  for (std::size_t unit = 0; unit < p.size(); ++unit) {
    p[unit] = sumsA[unit].pixels > 0.0
                  ? welchTwoSided(sumsA[unit].estimate(), sumsB[unit].estimate())
                  : std::numeric_limits<double>::quiet_NaN();
  }
  return judgeFamily(p, grid, alpha);
}

}  // namespace twintrace
