#pragma once

#include <array>

#include "common/stats/batch_means.h"
#include "common/stats/image_estimate.h"
#include "common/stats/welch.h"

namespace twintrace {

inline constexpr double kEquivalenceBound = 0.005;
inline constexpr double kEquivalenceAlpha = 0.001;

/// Answer to "are the picture means equal within the bound?".
struct Equivalence {
  double bound = kEquivalenceBound;  ///< largest |mean a / mean b - 1| that counts as equal
  double alpha = kEquivalenceAlpha;
  std::array<double, 3> channelP{1.0, 1.0, 1.0};
  double p = 1.0;           ///< the largest of channelP
  bool equivalent = false;  ///< p <= alpha
};

using ChannelMeans = std::array<MeanEstimate, 3>;

/// Mean of the whole picture per channel, from at least two batches.
ChannelMeans channelMeans(const BatchMeans& arm);

/// The same from per-pixel standard errors, taking pixels as independent. Values that are not
/// finite are left out; an unknown error of one value makes that of the channel unknown.
ChannelMeans channelMeans(const ImageEstimate& picture);

/// Two one-sided tests (Schuirmann 1987) per channel that mean a / mean b lies within 1 +- bound,
/// on the linear forms mean a - (1 -+ bound) mean b (Sasabuchi 1988), so that the error of the
/// divisor counts, too. All channels have to pass, hence no correction (Berger 1982). Without any
/// error the answer is exact; two channels that are 0 are equal.
/// @throws UsageError unless 0 < bound < 1 and 0 < alpha < 1.
Equivalence equivalenceTest(const ChannelMeans& a, const ChannelMeans& b,
                            double bound = kEquivalenceBound, double alpha = kEquivalenceAlpha);

}  // namespace twintrace
