#include "common/stats/welch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/stats/distributions.h"

namespace twintrace {

namespace {

/// t without the part that the skewness of the difference explains: Hall's monotone cubic, "On the
/// removal of skewness by transformation", 1992, with the change that it never moves t away from 0.
double withoutSkewness(double t, double skewness) {
  const double shift = skewness * t * t / 3.0 + skewness / 6.0;
  const double transformed = t + shift + skewness * skewness * t * t * t / 27.0;
  if (transformed * t <= 0.0) return 0.0;
  return std::abs(transformed) < std::abs(t) ? transformed : t;
}

}  // namespace

MeanEstimate meanEstimate(std::span<const double> values) {
  // Equal values have no error; their rounded mean must not make one up.
  const bool constant =
      std::all_of(values.begin(), values.end(), [&](double v) { return v == values[0]; });
  const double count = static_cast<double>(values.size());
  if (constant) return {values[0], 0.0, count - 1.0};
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  double squares = 0.0;
  double cubes = 0.0;
  for (const double value : values) {
    const double deviation = value - mean;
    squares += deviation * deviation;
    cubes += deviation * deviation * deviation;
  }
  const double thirdCumulant = count > 2.0 ? cubes / (count * (count - 1.0) * (count - 2.0)) : 0.0;
  return {mean, std::sqrt(squares / (count - 1.0) / count), count - 1.0, thirdCumulant};
}

double welchDof(double squaredErrorA, double dofA, double squaredErrorB, double dofB) {
  const double sum = squaredErrorA + squaredErrorB;
  const double divisor =
      squaredErrorA * squaredErrorA / dofA + squaredErrorB * squaredErrorB / dofB;
  // Squares of tiny errors underflow; the smaller sample then bounds the degrees of freedom.
  return divisor > 0.0 ? sum * sum / divisor : std::min(dofA, dofB);
}

double welchTwoSided(const MeanEstimate& a, const MeanEstimate& b) {
  const double squaredA = a.standardError * a.standardError;
  const double squaredB = b.standardError * b.standardError;
  const double error = std::sqrt(squaredA + squaredB);
  if (std::isinf(error)) return 1.0;
  if (error == 0.0) return a.mean == b.mean ? 1.0 : 0.0;
  const double t = (a.mean - b.mean) / error;
  const double skewness = (a.thirdCumulant - b.thirdCumulant) / (error * error * error);
  return studentTwoSided(withoutSkewness(t, skewness), welchDof(squaredA, a.dof, squaredB, b.dof));
}

}  // namespace twintrace
