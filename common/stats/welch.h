#pragma once

#include <span>

namespace twintrace {

/// A mean with its standard error and the degrees of freedom of that.
struct MeanEstimate {
  double mean = 0.0;
  double standardError = 0.0;
  double dof = 1.0;            ///< infinity: the standard error is exact
  double thirdCumulant = 0.0;  ///< of the mean: its skewness times standardError^3; 0 if not known
};

/// Mean of independent values; at least two.
MeanEstimate meanEstimate(std::span<const double> values);

/// Degrees of freedom of a weighted sum of independent means (Welch 1947, Satterthwaite 1946).
double welchDof(double squaredErrorA, double dofA, double squaredErrorB, double dofB);

/// Welch's two-sided test that two means are equal. Where skewness of the values explains part of
/// the difference, t is made smaller by Hall's transformation (1992): rare bright values that an
/// arm happens to miss lower both its mean and its error, and plain t then rejects far too often.
/// t is never made larger. Without any error in either, the answer is exact: 1 if the means are
/// equal, 0 if not. An error that is not known (infinite) gives 1.
double welchTwoSided(const MeanEstimate& a, const MeanEstimate& b);

}  // namespace twintrace
