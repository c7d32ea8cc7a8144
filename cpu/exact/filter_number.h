#pragma once

#include <cmath>
#include <limits>

namespace twintrace::exact {

/// Thrown where rounding hides a sign, so that exact numbers must decide.
struct Uncertain {};

/// A real number known to within a running error bound (Wilkinson 1963; as a filter before exact
/// arithmetic: Fortune and Van Wyk 1996). Long double, since on x86 it holds products of floats
/// without rounding, and no product of float inputs that the predicates form leaves its range.
class FilterNumber {
 public:
  FilterNumber(float value) : value_(value) {}
  FilterNumber(long double value, long double error) : value_(value), error_(error) {}

  /// -1, 0 or 1. @throws Uncertain if the error bound does not tell.
  int sign() const {
    const long double bound = error_ * kBoundSlack;
    if (value_ > bound) return 1;
    if (value_ < -bound) return -1;
    if (value_ == 0.0L && error_ == 0.0L) return 0;
    throw Uncertain{};
  }

  long double value() const { return value_; }
  long double error() const { return error_ * kBoundSlack; }

  friend FilterNumber operator-(const FilterNumber& a) { return {-a.value_, a.error_}; }
  friend FilterNumber operator+(const FilterNumber& a, const FilterNumber& b) {
    return rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend FilterNumber operator-(const FilterNumber& a, const FilterNumber& b) {
    return rounded(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend FilterNumber operator*(const FilterNumber& a, const FilterNumber& b) {
    return rounded(a.value_ * b.value_, std::fabs(a.value_) * b.error_ +
                                            std::fabs(b.value_) * a.error_ + a.error_ * b.error_);
  }
  /// @param b certainly not zero
  friend FilterNumber operator/(const FilterNumber& a, const FilterNumber& b) {
    const long double quotient = a.value_ / b.value_;
    return rounded(quotient,
                   (a.error_ + std::fabs(quotient) * b.error_) / (std::fabs(b.value_) - b.error_));
  }
  /// @param a certainly not negative
  friend FilterNumber squareRoot(const FilterNumber& a) {
    if (a.value_ == 0.0L) return a;
    const long double root = std::sqrt(a.value_);
    return rounded(root, a.error_ / root);
  }

 private:
  /// The bounds themselves are rounded, by less than 8 * 2^-64 of their size per operation: no
  /// chain of fewer than 2^20 operations outgrows this slack.
  static constexpr long double kBoundSlack = 1.0L + 0x1p-40L;

  static FilterNumber rounded(long double value, long double error) {
    return {value, error + std::fabs(value) * std::numeric_limits<long double>::epsilon()};
  }

  long double value_;
  long double error_ = 0.0L;
};

}  // namespace twintrace::exact
