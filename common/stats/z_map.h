#pragma once

#include "common/stats/image_estimate.h"

namespace twintrace {

/// Where two independent pictures differ, in standard errors: a map, not a verdict.
struct ZMap {
  Image z;                        ///< (a - b) / error; 0 for equal values, infinite without error
  double rejectedFraction = 0.0;  ///< of values beyond Benjamini and Hochberg's cut
};

/// The map of two pictures. Values that are not finite in either picture get NaN, those with an
/// unknown error 0; both count as not rejected.
/// @param falseDiscoveryRate in (0, 0.3).
/// @throws UsageError if the sizes differ or the rate is out of range.
ZMap zMap(const ImageEstimate& a, const ImageEstimate& b, double falseDiscoveryRate);

}  // namespace twintrace
