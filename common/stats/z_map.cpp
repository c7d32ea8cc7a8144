#include "common/stats/z_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/stats/distributions.h"
#include "common/stats/multiple_testing.h"
#include "common/stats/welch.h"

namespace twintrace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

MeanEstimate valueEstimate(const ImageEstimate& picture, std::size_t i) {
  const double dof = picture.count.empty() ? kInfinity : picture.count[i / 3] - 1.0;
  return {picture.mean.rgb[i], picture.standardError.rgb[i], dof};
}

double zOf(const MeanEstimate& a, const MeanEstimate& b) {
  const double difference = a.mean - b.mean;
  if (difference == 0.0) return 0.0;
  return difference / std::hypot(a.standardError, b.standardError);
}

}  // namespace

ZMap zMap(const ImageEstimate& a, const ImageEstimate& b, double falseDiscoveryRate) {
  requireSameSize(a.mean, b.mean);
  if (!(falseDiscoveryRate > 0.0 && falseDiscoveryRate < 0.3)) {
    throw UsageError("found a false discovery rate of " + std::to_string(falseDiscoveryRate) +
                     ", expected a number between 0 and 0.3");
  }
  ZMap map;
  map.z = Image(a.mean.width, a.mean.height);
  // Below one standard error p is above 0.31 for any degrees of freedom, so above every cut: 1 does
  // as well and saves most of the time.
  std::vector<double> p(a.mean.rgb.size(), 1.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const MeanEstimate valueA = valueEstimate(a, i);
    const MeanEstimate valueB = valueEstimate(b, i);
    const bool finite = std::isfinite(valueA.mean) && std::isfinite(valueB.mean);
    const double z = finite ? zOf(valueA, valueB) : std::numeric_limits<double>::quiet_NaN();
    map.z.rgb[i] = static_cast<float>(z);
    if (std::abs(z) > 1.0) p[i] = welchTwoSided(valueA, valueB);
  }
  const double cut = benjaminiHochbergCut(p, falseDiscoveryRate);
  const auto rejected =
      std::count_if(p.begin(), p.end(), [&](double value) { return value <= cut; });
  map.rejectedFraction = static_cast<double>(rejected) / static_cast<double>(p.size());
  return map;
}

}  // namespace twintrace
