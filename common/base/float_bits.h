#pragma once

#include <bit>
#include <cstdint>

namespace twintrace {

/// Maps a float to an integer that grows with it: neighbouring floats differ by 1, and -0 and +0
/// both map to 0. NaN has no place in this order.
inline std::int64_t orderedBits(float value) {
  const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(value) & 0x7fffffffu);
  return std::bit_cast<std::uint32_t>(value) >> 31 != 0 ? -bits : bits;
}

/// Distance of two floats in units in the last place; 0 also for NaN against NaN and for -0 against
/// +0, 2^32 - 1 for NaN against a number.
inline std::uint32_t ulpDistance(float a, float b) {
  const bool aIsNan = a != a;
  const bool bIsNan = b != b;
  if (aIsNan || bIsNan) return aIsNan && bIsNan ? 0u : 0xffffffffu;
  const std::int64_t distance = orderedBits(a) - orderedBits(b);
  return static_cast<std::uint32_t>(distance < 0 ? -distance : distance);
}

/// Equality of results as strict maths means it: same bits, except that NaN equals NaN and the sign
/// of zero is free.
inline bool sameBits(float a, float b) { return ulpDistance(a, b) == 0; }

}  // namespace twintrace
