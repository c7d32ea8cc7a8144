#pragma once

#include <optional>

#include "cpu/exact/dyadic.h"
#include "cpu/exact/filter_number.h"

namespace twintrace::exact {

/// A parameter t of a ray as (p + branch * sqrt(d)) / q: spheres are met at quadratic surds, all
/// else at fractions.
template <class N>
struct Root {
  N p;
  N q;             ///< positive
  int branch = 0;  ///< -1, 0 or 1
  N d = N(0.0f);   ///< not negative
};

/// Sign of a + s sqrt(x) + r sqrt(y), x and y not negative. @throws Uncertain
inline int signOfSum(const FilterNumber& a, int s, const FilterNumber& x, int r,
                     const FilterNumber& y) {
  FilterNumber sum = a;
  if (s != 0) sum = s > 0 ? sum + squareRoot(x) : sum - squareRoot(x);
  if (r != 0) sum = r > 0 ? sum + squareRoot(y) : sum - squareRoot(y);
  return sum.sign();
}

/// Sign of a + s sqrt(x).
int signOfSum(const Dyadic& a, int s, const Dyadic& x);

/// Sign of a + s sqrt(x) + r sqrt(y), by squaring twice.
int signOfSum(const Dyadic& a, int s, const Dyadic& x, int r, const Dyadic& y);

/// -1, 0 or 1 as the first root is smaller, equal or larger.
template <class N>
int compare(const Root<N>& a, const Root<N>& b) {
  const N difference = a.p * b.q - b.p * a.q;
  if (a.branch == 0 && b.branch == 0) return difference.sign();
  const N zero(0.0f);
  return signOfSum(difference, a.branch, a.branch != 0 ? b.q * b.q * a.d : zero, -b.branch,
                   b.branch != 0 ? a.q * a.q * b.d : zero);
}

/// The root to within 1 ulp of double, or nothing if the error bound is larger than that.
std::optional<double> toDouble(const Root<FilterNumber>& root);

/// The root to within 1 ulp of double.
double toDouble(const Root<Dyadic>& root);

/// The same root for the filter.
Root<FilterNumber> filtered(const Root<Dyadic>& root);

}  // namespace twintrace::exact
