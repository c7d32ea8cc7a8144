#pragma once

// Twin of shaders/corrected.glsl: correctly rounded division and square root from approximate ones.
// The processor's own are correctly rounded, so that only tests call these, for scalars.

#include "cpu/kernel/number.h"

TWINTRACE_KERNEL_BEGIN

inline constexpr std::uint32_t kInfinityBits = 0x7f800000u;
inline constexpr std::uint32_t kNanBits = 0x7fc00000u;

inline float approximateQuotient(float a, float b) { return a / b; }

inline float approximateRoot(float x) { return rootOf(x); }

/// The mantissa of those bits as an integer in [2^23, 2^24).
inline std::uint32_t mantissaOf(std::uint32_t bits) { return (bits & 0x007fffffu) | 0x00800000u; }

/// The same mantissa as a float in [1, 2).
inline float unitMantissa(float x) {
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(x) & 0x007fffffu) | 0x3f800000u);
}

/// A float from sign, biased exponent and a mantissa in [2^23, 2^24]: infinite beyond the range of
/// normal numbers, zero below it.
inline std::uint32_t composedBits(std::uint32_t sign, std::int32_t exponent,
                                  std::uint32_t mantissa) {
  const std::int32_t held = select(exponent < 0, 0, select(exponent > 255, 255, exponent));
  const std::uint32_t size = (toUnsigned(held) << 23) + mantissa - 0x00800000u;
  const std::uint32_t finite = select(size < 0x00800000u, 0u, size);
  const std::uint32_t known = select(size < kInfinityBits, finite, kInfinityBits);
  return sign | select(exponent < 0, 0u, known);
}

/// The quotient where an operand is zero (a denormal counts as zero), infinite or NaN; sizes are the
/// operands without sign.
inline std::uint32_t specialQuotientBits(std::uint32_t sign, std::uint32_t sizeA,
                                         std::uint32_t sizeB) {
  const bool zeroA = sizeA < 0x00800000u;
  const bool zeroB = sizeB < 0x00800000u;
  const bool infiniteA = sizeA == kInfinityBits;
  const bool infiniteB = sizeB == kInfinityBits;
  const bool undefinedSize = sizeA > kInfinityBits || sizeB > kInfinityBits;
  const bool undefinedPair = (zeroA && zeroB) || (infiniteA && infiniteB);
  const std::uint32_t size = select(zeroB || infiniteA, kInfinityBits, 0u);
  return select(undefinedSize || undefinedPair, kNanBits, sign | size);
}

/// a / b to the nearest float, from a guess at the quotient of their unit mantissas that is off by
/// at most 4 ulp.
inline float refinedQuotient(float a, float b, float guess) {
  const auto bitsA = std::bit_cast<std::uint32_t>(a);
  const auto bitsB = std::bit_cast<std::uint32_t>(b);
  const std::uint32_t sizeA = bitsA & 0x7fffffffu;
  const std::uint32_t sizeB = bitsB & 0x7fffffffu;
  const std::uint32_t sign = (bitsA ^ bitsB) & 0x80000000u;
  const std::uint32_t mantissaA = mantissaOf(bitsA);
  const std::uint32_t mantissaB = mantissaOf(bitsB);
  const std::uint32_t low = select(mantissaA < mantissaB, 1u, 0u);
  const float scale = select(mantissaA < mantissaB, 16777216.0f, 8388608.0f);
  std::uint32_t q = toUnsigned(toInt(guess * scale)) - 8u;
  std::uint32_t rest = (mantissaA << (23u + low)) - q * mantissaB;
  for (std::uint32_t step = 8u; step > 0u; step = step >> 1) {
    const std::uint32_t part = select(rest < step * mantissaB, 0u, step);
    q = q + part;
    rest = rest - part * mantissaB;
  }
  const std::uint32_t rounded = q + select(2u * rest > mantissaB, 1u, 0u);
  const std::int32_t exponent = toSigned(sizeA >> 23) - toSigned(sizeB >> 23) + 127 - toSigned(low);
  const bool ordinaryA = sizeA >= 0x00800000u && sizeA < kInfinityBits;
  const bool ordinaryB = sizeB >= 0x00800000u && sizeB < kInfinityBits;
  return std::bit_cast<float>(select(ordinaryA && ordinaryB, composedBits(sign, exponent, rounded),
                                     specialQuotientBits(sign, sizeA, sizeB)));
}

/// The mantissa of x as a float in [1, 4), so that an even exponent is left.
inline float rootMantissa(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t exponent = select(((bits >> 23) & 1u) == 0u, 0x40000000u, 0x3f800000u);
  return std::bit_cast<float>((bits & 0x007fffffu) | exponent);
}

/// sqrt(x) to the nearest float, from a guess at the root of its root mantissa that is off by at most
/// 4 ulp.
inline float refinedRoot(float x, float guess) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t size = bits & 0x7fffffffu;
  const std::uint32_t odd = select(((bits >> 23) & 1u) == 0u, 1u, 0u);
  std::uint32_t q = toUnsigned(toInt(guess * 8388608.0f)) - 8u;
  std::uint32_t rest = (mantissaOf(bits) << (23u + odd)) - q * q;
  for (std::uint32_t step = 8u; step > 0u; step = step >> 1) {
    const std::uint32_t growth = (2u * q + step) * step;
    const bool fits = rest >= growth;
    q = q + select(fits, step, 0u);
    rest = rest - select(fits, growth, 0u);
  }
  const std::uint32_t rounded = q + select(rest > q, 1u, 0u);
  const std::int32_t exponent = (toSigned(size >> 23) - 127 - toSigned(odd)) / 2 + 127;
  const bool positive = bits >= 0x00800000u && bits < kInfinityBits;
  const bool kept = size < 0x00800000u || bits == kInfinityBits;
  const std::uint32_t ending = select(size < 0x00800000u, bits & 0x80000000u, bits);
  const std::uint32_t special = select(kept, ending, kNanBits);
  return std::bit_cast<float>(select(positive, composedBits(0u, exponent, rounded), special));
}

/// a / b to the nearest float; denormals are zero.
inline float correctedQuotient(float a, float b) {
  const float guess = approximateQuotient(unitMantissa(a), unitMantissa(b));
  return refinedQuotient(a, b, guess);
}

/// sqrt(x) to the nearest float; denormals are zero.
inline float correctedRoot(float x) {
  const float guess = approximateRoot(rootMantissa(x));
  return refinedRoot(x, guess);
}

TWINTRACE_KERNEL_END
