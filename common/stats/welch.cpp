#include "common/stats/welch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/stats/distributions.h"

namespace twintrace {

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
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / (count - 1.0) / count), count - 1.0};
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
  return studentTwoSided((a.mean - b.mean) / error, welchDof(squaredA, a.dof, squaredB, b.dof));
}

}  // namespace twintrace
