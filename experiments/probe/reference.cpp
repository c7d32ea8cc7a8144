#include "experiments/probe/reference.h"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace twintrace::probe {
namespace {

// Sums of products of floats are exact with as many bits: exponents from -298 to 256.
constexpr mpfr_prec_t kExactBits = 640;
constexpr mpfr_prec_t kFloatBits = 24;

/// A number of MPFR; floats go in exactly.
class Real {
 public:
  explicit Real(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  explicit Real(float value) : Real(kExactBits) { mpfr_set_flt(value_, value, MPFR_RNDN); }
  ~Real() { mpfr_clear(value_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;

  operator mpfr_ptr() { return value_; }
  float toFloat() { return mpfr_get_flt(value_, MPFR_RNDN); }

 private:
  mpfr_t value_;
};

bool isNormal(float x) { return std::isnormal(x); }

/// Zero, or a normal float that keeps all quotients and products of two in the range of floats.
bool isModerate(float x) {
  return x == 0.0f || (std::fabs(x) >= 0x1p-40f && std::fabs(x) <= 0x1p40f);
}

template <int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t)>
float rounded(float x) {
  Real given(x);
  Real result(kFloatBits);
  function(result, given, MPFR_RNDN);
  return result.toFloat();
}

template <int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t)>
float rounded(float a, float b) {
  Real first(a);
  Real second(b);
  Real result(kFloatBits);
  function(result, first, second, MPFR_RNDN);
  return result.toFloat();
}

bool quotient(const float* in, float* out) {
  if (!isNormal(in[0]) || !isNormal(in[1])) return false;
  out[0] = rounded<mpfr_div>(in[0], in[1]);
  return true;
}

bool quotients(const float* in, float* out) {
  const auto divided = [&](int i) {
    const float given[] = {in[i], in[3]};
    return quotient(given, out + i);
  };
  return divided(0) && divided(1) && divided(2);
}

bool root(const float* in, float* out) {
  if (!isNormal(in[0]) || in[0] < 0.0f) return false;
  out[0] = rounded<mpfr_sqrt>(in[0]);
  return true;
}

/// sine() promises accuracy below 50,000 only.
bool sineOf(const float* in, float* out) {
  if (!(std::fabs(in[0]) < 50000.0f)) return false;
  out[0] = rounded<mpfr_sin>(in[0]);
  return true;
}

bool turns(const float* in, float* out) {
  if (!(in[0] >= 0.0f && in[0] <= 1.0f)) return false;
  Real u(in[0]);
  Real result(kFloatBits);
  mpfr_sinu(result, u, 1, MPFR_RNDN);
  out[0] = result.toFloat();
  mpfr_cosu(result, u, 1, MPFR_RNDN);
  out[1] = result.toFloat();
  return true;
}

/// The second word is an integer: quarter turns to add to the angle.
bool reducedSineCosine(const float* in, float* out) {
  if (!(std::fabs(in[0]) <= 0.7853982f)) return false;
  const std::uint32_t quarters = std::bit_cast<std::uint32_t>(in[1]);
  const float s = rounded<mpfr_sin>(in[0]);
  const float c = rounded<mpfr_cos>(in[0]);
  const float sineSize = (quarters & 1u) != 0u ? c : s;
  const float cosineSize = (quarters & 1u) != 0u ? s : c;
  out[0] = (quarters & 2u) != 0u ? -sineSize : sineSize;
  out[1] = ((quarters + 1u) & 2u) != 0u ? -cosineSize : cosineSize;
  return true;
}

bool logarithm(const float* in, float* out) {
  if (!isNormal(in[0]) || in[0] < 0.0f) return false;
  out[0] = rounded<mpfr_log2>(in[0]);
  return true;
}

bool exponential(const float* in, float* out) {
  if (!(in[0] >= -126.0f && in[0] <= 127.0f)) return false;
  out[0] = rounded<mpfr_exp2>(in[0]);
  return true;
}

/// Where the result stays in the range in which exp2Of() does not hold its argument.
bool powerOf(const float* in, float* out) {
  if (!isNormal(in[0]) || in[0] < 0.0f || !isNormal(in[1]) || in[1] < 0.0f) return false;
  out[0] = rounded<mpfr_pow>(in[0], in[1]);
  return out[0] >= 0x1p-126f && out[0] <= 0x1p127f;
}

bool angleOf(const float* in, float* out) {
  const bool origin = in[0] == 0.0f && in[1] == 0.0f;
  if (origin || !isModerate(in[0]) || !isModerate(in[1])) return false;
  out[0] = rounded<mpfr_atan2>(in[0], in[1]);
  // The shader's zeros have no sign: the angle on the negative axis is pi.
  if (in[0] == 0.0f) out[0] = std::fabs(out[0]);
  return true;
}

bool arcCosineOf(const float* in, float* out) {
  if (!(in[0] >= -1.0f && in[0] <= 1.0f)) return false;
  out[0] = rounded<mpfr_acos>(in[0]);
  return true;
}

bool areModerate(const float* in, int count) { return std::all_of(in, in + count, isModerate); }

void addProduct(Real& sum, float a, float b, bool subtract = false) {
  Real product(a);
  Real other(b);
  mpfr_mul(product, product, other, MPFR_RNDN);
  if (subtract) {
    mpfr_sub(sum, sum, product, MPFR_RNDN);
  } else {
    mpfr_add(sum, sum, product, MPFR_RNDN);
  }
}

bool dotProduct(const float* in, float* out) {
  if (!areModerate(in, 6)) return false;
  Real sum(0.0f);
  for (int i = 0; i < 3; ++i) addProduct(sum, in[i], in[3 + i]);
  out[0] = sum.toFloat();
  return true;
}

bool crossProduct(const float* in, float* out) {
  if (!areModerate(in, 6)) return false;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    Real sum(0.0f);
    addProduct(sum, in[j], in[3 + k]);
    addProduct(sum, in[k], in[3 + j], true);
    out[i] = sum.toFloat();
  }
  return true;
}

bool lengthOf(const float* in, float* out) {
  if (!areModerate(in, 3)) return false;
  Real sum(0.0f);
  for (int i = 0; i < 3; ++i) addProduct(sum, in[i], in[i]);
  Real result(kFloatBits);
  mpfr_sqrt(result, sum, MPFR_RNDN);
  out[0] = result.toFloat();
  return true;
}

bool unitVectorOf(const float* in, float* out) {
  if (!areModerate(in, 3) || (in[0] == 0.0f && in[1] == 0.0f && in[2] == 0.0f)) return false;
  Real squared(0.0f);
  for (int i = 0; i < 3; ++i) addProduct(squared, in[i], in[i]);
  // v / |v| = sign(v) sqrt(v^2 / |v|^2): the inner quotient is rounded at 640 bits, far from any tie.
  for (int i = 0; i < 3; ++i) {
    Real ratio(0.0f);
    addProduct(ratio, in[i], in[i]);
    mpfr_div(ratio, ratio, squared, MPFR_RNDN);
    Real result(kFloatBits);
    mpfr_sqrt(result, ratio, MPFR_RNDN);
    out[i] = std::copysign(result.toFloat(), in[i]);
  }
  return true;
}

constexpr Reference kReferences[] = {
    {"divide(float, float)", "a / b", &quotient},
    {"divide(vec3, float)", "a / b", &quotients},
    {"squareRoot(float)", "sqrt x", &root},
    {"correctedQuotient(float, float)", "a / b", &quotient},
    {"correctedRoot(float)", "sqrt x", &root},
    {"dot3(vec3, vec3)", "a . b", &dotProduct},
    {"cross3(vec3, vec3)", "a x b", &crossProduct},
    {"length3(vec3)", "|v|", &lengthOf},
    {"normalize3(vec3)", "v / |v|", &unitVectorOf},
    {"sinCosReduced(float, int)", "sin, cos (angle + quarters pi / 2)", &reducedSineCosine},
    {"sinCosTurns(float)", "sin, cos 2 pi u", &turns},
    {"sine(float)", "sin x", &sineOf},
    {"log2Of(float)", "log2 x", &logarithm},
    {"exp2Of(float)", "2^x", &exponential},
    {"power(float, float)", "x^y", &powerOf},
    {"arcTangent2(float, float)", "atan2(y, x)", &angleOf},
    {"arcCosine(float)", "acos x", &arcCosineOf},
};

}  // namespace

const Reference* referenceOf(std::string_view signature) {
  const auto found = std::ranges::find(kReferences, signature, &Reference::signature);
  return found != std::end(kReferences) ? found : nullptr;
}

}  // namespace twintrace::probe
