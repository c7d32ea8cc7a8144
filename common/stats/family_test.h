#pragma once

#include <cstddef>
#include <optional>

#include "common/stats/batch_means.h"
#include "common/stats/image_estimate.h"

namespace twintrace {

/// Fewest batches per arm: with fewer, neither Welch's test nor a relabelling can reach the
/// p-values of about alpha / 1e4 that a family of this size needs.
inline constexpr std::size_t kMinBatchCount = 32;

/// Answer to "do these arms, drawn independently, differ in the mean of any block?".
struct FamilyTest {
  double alpha = 0.0;          ///< bound on the chance of a false alarm of the whole family
  std::size_t familySize = 0;  ///< block-channels tested
  std::size_t untested = 0;    ///< block-channels without finite values with a known error
  std::size_t rejected = 0;    ///< block-channels with a Holm-adjusted p <= alpha
  double smallestP = 1.0;      ///< smallest Holm-adjusted p
  double permutationP = 1.0;   ///< of the confirming test; 1 where it was not run
  PixelPosition worstBlock;    ///< upper left pixel of the block with the smallest p
  int worstChannel = 0;
  bool different = false;

  bool wasRun() const { return familySize + untested > 0; }
};

/// The unpaired test on batches. Welch's t, freed of skewness, on each block-channel, Holm over all
/// of them; if that rejects, the max T relabelling test has to reject as well.
///
/// Why two tests: Welch's t is conservative for skewed and heavy-tailed block means (fireflies hit
/// one arm only and inflate its error), but far out in the tail it is too liberal for light-tailed
/// ones, such as a block that is either lit or not: for 32 + 32 fair coins p is 5 times too small
/// at 1e-6. Relabelling is exact for equal arms, whatever their distribution, but its p can't be
/// smaller than 1 / (permutations + 1), so it can't be corrected block by block. Requiring both
/// keeps the false-alarm rate at or below alpha for A/A pairs, and the relabelling costs time only
/// when there is something to confirm.
///
/// Arms with equal means but unequal skewness (say, two estimators, one of them with fireflies) are
/// not A/A pairs: no test of means is exact for them. Measured at alpha 0.01 with 32 batches, tight
/// normal values against lognormal ones of sigma 1, 1.5, 2: 1, 4 and 12 % false alarms (plain
/// Welch: 3, 9 and 34 %). More samples per batch are the cure.
/// @param alpha in (0, 1). Below 1e-5 the confirming test stays at 1e-5 and Welch's decides.
/// @throws UsageError if an arm has fewer than kMinBatchCount batches, sizes or alpha are wrong.
FamilyTest familyTest(const BatchMeans& a, const BatchMeans& b, double alpha);

/// The same question for two pictures with standard errors but without batches: a t-test per
/// block-channel from the per-pixel errors, taking pixels as independent, and Holm over all.
/// Pixels that are not finite or have no known error in either picture are left out.
/// @throws UsageError if sizes or alpha are wrong.
FamilyTest familyTest(const ImageEstimate& a, const ImageEstimate& b, double alpha);

}  // namespace twintrace
