#pragma once

#include <cstdint>

#include "common/stats/batch_means.h"

namespace twintrace {

/// Chance that batches dealt at random to two arms differ somewhere as strongly as these do: the
/// largest |Welch t| over all block-channels against its distribution under random relabelling of
/// whole batches (Westfall and Young 1993, max T; studentised as by Janssen 1997, so that it stays
/// valid for large counts when only the means are equal). Exact for equally distributed arms: no
/// normality, no independence of blocks. Block-channels with a NaN in any batch are left out.
/// @param permutations relabellings drawn; the result is a multiple of 1 / (permutations + 1).
/// @param seed of the relabellings.
double maxTPermutationP(const BatchMeans& a, const BatchMeans& b, int permutations,
                        std::uint64_t seed);

}  // namespace twintrace
