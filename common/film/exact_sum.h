#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace twintrace {

using Int128 = __int128;
using Uint128 = unsigned __int128;

/// Frames that a film can hold. With |frame value| < 2^30 the sum stays below 2^54 and the sum of
/// squares below 2^84, which with 64 and 44 fractional bits just fits into 128 bits.
inline constexpr std::uint32_t kMaxFrames = 1u << 24;

/// Fractional bits of the sum and of the sum of squares.
inline constexpr int kSumFraction = 64;
inline constexpr int kSquareFraction = 44;

namespace exact_sum_detail {

/// value * 2^shift on the integer grid, rounded to nearest, ties to even; value < 2^48, shift < 80.
/// Without branches: pictures mix bright and dark pixels, and a wrong guess costs more than both
/// shifts.
inline Uint128 shiftToGrid(std::uint64_t value, int shift) {
  const int left = std::max(shift, 0);
  const int right = std::clamp(-shift, 0, 50);
  const std::uint64_t belowHalf = ((std::uint64_t{1} << right) - 1) >> 1;
  const std::uint64_t odd = (value >> right) & (right > 0 ? 1u : 0u);
  return static_cast<Uint128>((value + belowHalf + odd) >> right) << left;
}

}  // namespace exact_sum_detail

/// True if the value can be summed exactly: finite and |value| < 2^30.
inline bool inSumRange(float value) {
  return (std::bit_cast<std::uint32_t>(value) & 0x7f800000u) < (157u << 23);
}

/// Exact sums of one channel. Integers, so that any order of adding and merging gives the same
/// bits; a float is put on the grid from its mantissa and exponent, so that no rounding mode and no
/// flush to zero of the calling thread plays a part.
struct ChannelSum {
  Int128 sum = 0;       ///< sum of values, in units of 2^-64
  Uint128 squares = 0;  ///< sum of squares, in units of 2^-44

  /// Adds a value for which inSumRange() holds; its caller adds no more than kMaxFrames of them.
  /// The value is rounded to 2^-64 and its square to 2^-44, to nearest, ties to even.
  void add(float value) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    const int exponent = static_cast<int>(bits >> 23 & 0xffu);
    // A denormal has no hidden bit, but is far below the grid and becomes 0 with it, too.
    const std::uint64_t mantissa = (bits & 0x7fffffu) | 0x800000u;
    const auto magnitude =
        static_cast<Int128>(exact_sum_detail::shiftToGrid(mantissa, exponent - 150 + kSumFraction));
    const Int128 sign = -static_cast<Int128>(bits >> 31);
    sum += (magnitude ^ sign) - sign;
    squares +=
        exact_sum_detail::shiftToGrid(mantissa * mantissa, 2 * (exponent - 150) + kSquareFraction);
  }

  void merge(const ChannelSum& other) {
    sum += other.sum;
    squares += other.squares;
  }

  bool operator==(const ChannelSum&) const = default;
};

/// Mean of the `count` values in the sum, rounded once per operation; count > 0.
double meanOf(const ChannelSum& sums, std::uint32_t count);

/// Sample variance (divisor count - 1) of the values in the sum. The difference that cancels is
/// taken in 256-bit integers, so only the grid of the squares limits it. 0 if count < 2.
double varianceOf(const ChannelSum& sums, std::uint32_t count);

}  // namespace twintrace
