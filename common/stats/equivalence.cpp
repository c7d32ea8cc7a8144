#include "common/stats/equivalence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/stats/distributions.h"

namespace twintrace {
namespace {

void requireFraction(double value, const char* name) {
  if (value > 0.0 && value < 1.0) return;
  throw UsageError(std::string("found ") + name + " " + std::to_string(value) +
                   ", expected a number between 0 and 1");
}

/// p of the one-sided test that sign * (a - factor * b) > 0.
double oneSidedP(const MeanEstimate& a, const MeanEstimate& b, double factor, double sign) {
  const double difference = sign * (a.mean - factor * b.mean);
  const double squaredA = a.standardError * a.standardError;
  const double squaredB = factor * factor * b.standardError * b.standardError;
  const double error = std::sqrt(squaredA + squaredB);
  if (!std::isfinite(error) || !std::isfinite(difference)) return 1.0;
  if (error == 0.0) return difference > 0.0 ? 0.0 : 1.0;
  return studentUpper(difference / error, welchDof(squaredA, a.dof, squaredB, b.dof));
}

double channelP(const MeanEstimate& a, const MeanEstimate& b, double bound) {
  const bool exact = a.standardError == 0.0 && b.standardError == 0.0;
  if (exact && a.mean == 0.0 && b.mean == 0.0) return 0.0;
  const double sign = b.mean < 0.0 ? -1.0 : 1.0;
  return std::max(oneSidedP(a, b, 1.0 - bound, sign), oneSidedP(a, b, 1.0 + bound, -sign));
}

}  // namespace

ChannelMeans channelMeans(const BatchMeans& arm) {
  ChannelMeans means;
  std::vector<double> values(arm.batchCount());
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t batch = 0; batch < values.size(); ++batch)
      values[batch] = arm.imageMean(batch)[channel];
    means[channel] = meanEstimate(values);
  }
  return means;
}

ChannelMeans channelMeans(const ImageEstimate& picture) {
  std::array<double, 3> sums{};
  std::array<double, 3> squaredErrors{};
  std::array<double, 3> dofDivisors{};
  std::array<double, 3> pixels{};
  for (std::size_t i = 0; i < picture.mean.rgb.size(); ++i) {
    if (!std::isfinite(picture.mean.rgb[i])) continue;
    const double squared = double(picture.standardError.rgb[i]) * picture.standardError.rgb[i];
    sums[i % 3] += picture.mean.rgb[i];
    squaredErrors[i % 3] += squared;
    if (!picture.count.empty())
      dofDivisors[i % 3] += squared * squared / (picture.count[i / 3] - 1.0);
    pixels[i % 3] += 1.0;
  }
  ChannelMeans means;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double dof = dofDivisors[channel] > 0.0
                           ? squaredErrors[channel] * squaredErrors[channel] / dofDivisors[channel]
                           : std::numeric_limits<double>::infinity();
    means[channel] = {sums[channel] / pixels[channel],
                      std::sqrt(squaredErrors[channel]) / pixels[channel], dof};
  }
  return means;
}

Equivalence equivalenceTest(const ChannelMeans& a, const ChannelMeans& b, double bound,
                            double alpha) {
  requireFraction(bound, "bound");
  requireFraction(alpha, "alpha");
  Equivalence result;
  result.bound = bound;
  result.alpha = alpha;
  result.p = 0.0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    result.channelP[channel] = channelP(a[channel], b[channel], bound);
    result.p = std::max(result.p, result.channelP[channel]);
  }
  result.equivalent = result.p <= alpha;
  return result;
}

}  // namespace twintrace
