#pragma once

#include <cstdint>
#include <span>

namespace twintrace {

/// Result of a goodness-of-fit test.
struct ChiSquare {
  double statistic = 0.0;
  int dof = 0;
  double p = 1.0;  ///< chance of a fit as bad as this or worse if the expectation is right
};

/// Pearson's test of counts against their expectations. Neighbouring bins are pooled until each
/// pool expects at least 5, below which the chi-square tail is not to be trusted.
/// @param observed counts, one per bin.
/// @param expected expected counts in the same order, with the same total up to rounding.
/// @return p = 0 if a bin that expects exactly 0 was hit; p = 1 if only one pool is left.
/// @throws UsageError if the sizes differ, an expectation is negative or not finite, or the totals
/// differ by more than 1e-6 relatively: an integration error of that size moves the statistic of a
/// million draws by less than 1e-6, so it can't be mistaken for a misfit.
ChiSquare chiSquareTest(std::span<const std::uint64_t> observed, std::span<const double> expected);

}  // namespace twintrace
