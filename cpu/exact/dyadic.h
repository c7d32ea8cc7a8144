#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "cpu/exact/filter_number.h"

namespace twintrace::exact {

/// An exact number integer * 2^exponent. Sums and products of floats stay such numbers, so that,
/// unlike with fractions, no common divisors need to be looked for.
class Dyadic {
 public:
  using Integer =
      boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

  /// @param value finite
  Dyadic(float value) {
    constexpr int kBits = std::numeric_limits<float>::digits;
    const float fraction = std::frexp(value, &exponent_);
    integer_ = static_cast<long>(std::ldexp(fraction, kBits));
    exponent_ -= kBits;
  }

  int sign() const { return integer_.sign(); }
  const Integer& integer() const { return integer_; }
  int exponent() const { return exponent_; }

  friend Dyadic operator-(const Dyadic& a) { return {-a.integer_, a.exponent_}; }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    return {(a.integer_ << (a.exponent_ - b.exponent_)) + b.integer_, b.exponent_};
  }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.integer_ * b.integer_, a.exponent_ + b.exponent_};
  }

  /// The same number for the filter, rounded once.
  FilterNumber filtered() const {
    if (sign() == 0) return {0.0L, 0.0L};
    constexpr int kBits = 63;  // what a signed 64-bit integer holds
    const int excess = static_cast<int>(boost::multiprecision::msb(abs(integer_))) + 1 - kBits;
    const Integer top = excess > 0 ? Integer(integer_ / (Integer(1) << excess)) : integer_;
    const long double value = std::ldexp(static_cast<long double>(static_cast<long long>(top)),
                                         exponent_ + (excess > 0 ? excess : 0));
    // Cut to 63 bits, off by less than one unit of the last, and that is 2^-62 of the value at
    // most.
    return {value, excess > 0 ? std::fabs(value) * 0x1p-62L : 0.0L};
  }

 private:
  Dyadic(Integer integer, int exponent) : integer_(std::move(integer)), exponent_(exponent) {}

  Integer integer_;
  int exponent_ = 0;
};

}  // namespace twintrace::exact
