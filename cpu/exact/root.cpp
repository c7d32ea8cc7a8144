#include "cpu/exact/root.h"

#include <cmath>

namespace twintrace::exact {
namespace {

/// Enough digits for p + sqrt(d) to cancel and still leave a double: p has 24 + 277 bits per float
/// factor, and what is left of it after cancelling is at least p^2 - d, of four such factors, over
/// 2p.
using Real = boost::multiprecision::number<boost::multiprecision::gmp_float<1000>,
                                           boost::multiprecision::et_off>;

Real toReal(const Dyadic& number) {
  return ldexp(Real(number.integer()), number.exponent());
}

}  // namespace

int signOfSum(const Dyadic& a, int s, const Dyadic& x) {
  const int surd = s * x.sign();
  const int rest = a.sign();
  if (surd == 0 || rest == surd) return rest;
  if (rest == 0) return surd;
  return rest * (a * a - x).sign();
}

int signOfSum(const Dyadic& a, int s, const Dyadic& x, int r, const Dyadic& y) {
  const int first = s * x.sign();
  const int second = r * y.sign();
  if (second == 0) return signOfSum(a, first, x);
  if (first == 0) return signOfSum(a, second, y);
  const int surds = first == second ? first : first * (x - y).sign();
  const int rest = a.sign();
  if (surds == 0 || rest == surds) return rest;
  if (rest == 0) return surds;
  // a and the surds point apart: a^2 against x + y + 2 first second sqrt(x y).
  return rest * signOfSum(a * a - x - y, -first * second, Dyadic(4.0f) * x * y);
}

std::optional<double> toDouble(const Root<FilterNumber>& root) {
  FilterNumber numerator = root.p;
  if (root.branch > 0) numerator = numerator + squareRoot(root.d);
  if (root.branch < 0) numerator = numerator - squareRoot(root.d);
  const FilterNumber t = numerator / root.q;
  // Half an ulp from the rounding to double, and less than a quarter from here.
  if (!(t.error() <= std::fabs(t.value()) * 0x1p-55L)) return std::nullopt;
  return static_cast<double>(t.value());
}

double toDouble(const Root<Dyadic>& root) {
  Real numerator = toReal(root.p);
  if (root.branch != 0) numerator += root.branch * sqrt(toReal(root.d));
  return static_cast<double>(numerator / toReal(root.q));
}

Root<FilterNumber> filtered(const Root<Dyadic>& root) {
  return {root.p.filtered(), root.q.filtered(), root.branch, root.d.filtered()};
}

}  // namespace twintrace::exact
