#pragma once

namespace twintrace {

/// P(|Z| >= |z|) of the standard normal distribution; 0 for infinite z, 1 for NaN.
double normalTwoSided(double z);

/// P(|T| >= |t|) of Student's distribution; `dof` > 0, infinity means normal. 0 for infinite t, 1
/// for NaN.
double studentTwoSided(double t, double dof);

/// P(T >= t) of Student's distribution, as above.
double studentUpper(double t, double dof);

/// P(X >= x) of the chi-square distribution; x >= 0, dof > 0.
double chiSquareUpper(double x, double dof);

/// P(X >= count) for the binomial distribution of `trials` trials with probability `p`.
double binomialUpper(int count, int trials, double p);

}  // namespace twintrace
