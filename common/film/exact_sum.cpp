#include "common/film/exact_sum.h"

#include <cmath>

namespace twintrace {
namespace {

struct Uint256 {
  Uint128 high;
  Uint128 low;
};

Uint256 multiply(Uint128 a, Uint128 b) {
  const Uint128 mask = ~std::uint64_t{0};
  const Uint128 lowLow = (a & mask) * (b & mask);
  const Uint128 lowHigh = (a & mask) * (b >> 64);
  const Uint128 highLow = (a >> 64) * (b & mask);
  const Uint128 highHigh = (a >> 64) * (b >> 64);
  const Uint128 middle = (lowLow >> 64) + (lowHigh & mask) + (highLow & mask);
  return {highHigh + (lowHigh >> 64) + (highLow >> 64) + (middle >> 64),
          (middle << 64) | (lowLow & mask)};
}

bool lessOrEqual(const Uint256& a, const Uint256& b) {
  return a.high != b.high ? a.high < b.high : a.low <= b.low;
}

Uint256 subtract(const Uint256& a, const Uint256& b) {
  return {a.high - b.high - (a.low < b.low ? 1u : 0u), a.low - b.low};
}

double toDouble(const Uint256& value) {
  return std::ldexp(static_cast<double>(value.high), 128) + static_cast<double>(value.low);
}

}  // namespace

double meanOf(const ChannelSum& sums, std::uint32_t count) {
  return std::ldexp(static_cast<double>(sums.sum), -kSumFraction) / count;
}

double varianceOf(const ChannelSum& sums, std::uint32_t count) {
  if (count < 2) return 0.0;
  // count * sum of squares - (sum)^2, both in units of 2^-128.
  const Uint128 magnitude = static_cast<Uint128>(sums.sum < 0 ? -sums.sum : sums.sum);
  const Uint128 scale = static_cast<Uint128>(count) << (2 * kSumFraction - kSquareFraction);
  const Uint256 squares = multiply(sums.squares, scale);
  const Uint256 squaredSum = multiply(magnitude, magnitude);
  // Rounding of the squares to their grid can make the difference of equal values negative.
  if (lessOrEqual(squares, squaredSum)) return 0.0;
  const double difference = toDouble(subtract(squares, squaredSum));
  return std::ldexp(difference, -2 * kSumFraction) / (static_cast<double>(count) * (count - 1.0));
}

}  // namespace twintrace
