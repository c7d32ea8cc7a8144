#include "experiments/passport/exact_builtin.h"

#include <mpfr.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace twintrace {
namespace {

constexpr mpfr_prec_t kBits = 200;
constexpr double kUlpOfOne = 0x1p-23;

/// A number of 200 bits, so that a chain of a few operations is exact for our purposes.
class Number {
 public:
  Number() { mpfr_init2(value_, kBits); }
  Number(double x) : Number() { mpfr_set_d(value_, x, MPFR_RNDN); }
  Number(const Number& other) : Number() { mpfr_set(value_, other.value_, MPFR_RNDN); }
  Number& operator=(const Number&) = delete;
  ~Number() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }
  double toDouble() const { return mpfr_get_d(value_, MPFR_RNDN); }

 private:
  mpfr_t value_;
};

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

Number apply(Unary function, const Number& x) {
  Number result;
  function(result.get(), x.get(), MPFR_RNDN);
  return result;
}

Number apply(Binary function, const Number& x, const Number& y) {
  Number result;
  function(result.get(), x.get(), y.get(), MPFR_RNDN);
  return result;
}

Number operator+(const Number& x, const Number& y) { return apply(mpfr_add, x, y); }
Number operator-(const Number& x, const Number& y) { return apply(mpfr_sub, x, y); }
Number operator*(const Number& x, const Number& y) { return apply(mpfr_mul, x, y); }
Number operator/(const Number& x, const Number& y) { return apply(mpfr_div, x, y); }

template <Unary function>
double unary(float a, float, float) {
  return apply(function, Number(a)).toDouble();
}

template <Binary function>
double binary(float a, float b, float) {
  return apply(function, Number(a), Number(b)).toDouble();
}

Number lengthOf(float a, float b, float c) {
  return apply(mpfr_sqrt, Number(a) * a + Number(b) * b + Number(c) * c);
}

Number floorOf(const Number& x) {
  Number result;
  mpfr_floor(result.get(), x.get());
  return result;
}

// The equations of the GLSL specification, chapter 8.
double length(float a, float b, float c) { return lengthOf(a, b, c).toDouble(); }
double normalized(float a, float b, float c) { return (Number(a) / lengthOf(a, b, c)).toDouble(); }
double dot(float a, float b, float c) {
  return (Number(a) * c + Number(b) * a + Number(c) * b).toDouble();
}
double mix(float a, float b, float c) {
  return (Number(a) * (Number(1.0) - c) + Number(b) * c).toDouble();
}
double smoothStep(float a, float, float) {
  const Number t = std::clamp((double{a} - 0.25) / 0.5, 0.0, 1.0);  // exact: steps of powers of two
  return (t * t * (Number(3.0) - t * 2.0)).toDouble();
}
double reflected(float, float b, float c) {
  const Number y = double{0.6f};
  const Number z = double{0.8f};
  const Number twice = (y * b + z * c) * 2.0;
  return (Number(b) - twice * y).toDouble();
}
double fraction(float a, float, float) { return (Number(a) - floorOf(a)).toDouble(); }
double modulo(float a, float b, float) {
  return (Number(a) - Number(b) * floorOf(Number(a) / b)).toDouble();
}

double ulpOf(double x) {
  return std::exp2(std::max(std::ilogb(std::max(std::fabs(x), 0x1p-126)), -126) - 23);
}

double divisionBound(float, float, float) { return 2.5; }
double inverseRootBound(float, float, float) { return 2.0; }
// 1 / inversesqrt: 2 ulp of the root, of which one binade further on may be 4 of the result, and the
// division's own.
double rootBound(float, float, float) { return 2.0 * 2.0 + 2.5; }
double exp2Bound(float a, float, float) { return 3.0 + 2.0 * std::fabs(a); }

/// 3 ulp outside [0.5, 2], an absolute error of 2^-21 inside.
double logBound(float a, double exact) {
  return a < 0.5f || a > 2.0f ? 3.0 : 0x1p-21 / ulpOf(exact);
}
double log2Bound(float a, float, float) { return logBound(a, std::log2(double{a})); }
double naturalBound(float a, float, float) { return logBound(a, std::log(double{a})); }

/// exp2(y log2(x)): the logarithm's error and the product's rounding, magnified by the power, and
/// exp2's own.
double powerBound(float a, float b, float) {
  const double logarithm = std::log2(double{a});
  const double exponent = double{b} * logarithm;
  const double error = std::fabs(b) * logBound(a, logarithm) * ulpOf(logarithm) + ulpOf(exponent);
  return 2.0 * std::log(2.0) * error / kUlpOfOne + 3.0 + 2.0 * std::fabs(exponent);
}

constexpr const char* kNone = "none: undefined precision";
constexpr const char* kInherited = "inherited, no number";

constexpr ExactBuiltin kBuiltins[] = {
    {"a / b", binary<mpfr_div>, divisionBound, "2.5 ulp"},
    {"sqrt", unary<mpfr_sqrt>, rootBound, "inherited from 1 / inversesqrt(x): 6.5 ulp"},
    {"inversesqrt", unary<mpfr_rec_sqrt>, inverseRootBound, "2 ulp"},
    {"sin", unary<mpfr_sin>, nullptr, kNone},
    {"sin, |x| < 1000", unary<mpfr_sin>, nullptr, kNone},
    {"cos", unary<mpfr_cos>, nullptr, kNone},
    {"cos, |x| < 1000", unary<mpfr_cos>, nullptr, kNone},
    {"tan", unary<mpfr_tan>, nullptr, kNone},
    {"asin", unary<mpfr_asin>, nullptr, kNone},
    {"acos", unary<mpfr_acos>, nullptr, kNone},
    {"atan", unary<mpfr_atan>, nullptr, kNone},
    {"atan(y, x)", binary<mpfr_atan2>, nullptr, kNone},
    {"sinh", unary<mpfr_sinh>, nullptr, kInherited},
    {"cosh", unary<mpfr_cosh>, nullptr, kInherited},
    {"tanh", unary<mpfr_tanh>, nullptr, kInherited},
    {"exp", unary<mpfr_exp>, exp2Bound, "3 + 2 |x| ulp"},
    {"exp2", unary<mpfr_exp2>, exp2Bound, "3 + 2 |x| ulp"},
    {"log", unary<mpfr_log>, naturalBound, "3 ulp; 2^-21 in [0.5, 2]"},
    {"log2", unary<mpfr_log2>, log2Bound, "3 ulp; 2^-21 in [0.5, 2]"},
    {"pow", binary<mpfr_pow>, powerBound, "inherited from exp2(y log2(x))"},
    {"length", length, nullptr, kInherited},
    {"normalize, x", normalized, nullptr, kInherited},
    {"dot, positive", dot, nullptr, kInherited},
    {"mix", mix, nullptr, kInherited},
    {"smoothstep", smoothStep, nullptr, kInherited},
    {"reflect, y", reflected, nullptr, kInherited},
    {"fract", fraction, nullptr, kInherited},
    {"mod", modulo, nullptr, kInherited},
};

}  // namespace

const ExactBuiltin& exactBuiltin(std::string_view name) {
  const auto found = std::ranges::find(kBuiltins, name, &ExactBuiltin::name);
  assert(found != std::end(kBuiltins));
  return *found;
}

}  // namespace twintrace
