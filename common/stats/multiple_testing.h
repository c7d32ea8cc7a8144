#pragma once

#include <span>
#include <vector>

namespace twintrace {

/// Holm's step-down adjusted p-values, in the order given: rejecting those at or below alpha keeps
/// the chance of any false rejection at or below alpha, whatever the dependence (Holm 1979).
std::vector<double> holmAdjusted(std::span<const double> p);

/// The largest p-value that Benjamini and Hochberg's procedure (1995) rejects at false discovery
/// rate q; negative if it rejects none.
double benjaminiHochbergCut(std::vector<double> p, double q);

}  // namespace twintrace
