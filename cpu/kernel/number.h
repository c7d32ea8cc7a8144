#pragma once

// Twin of shaders/number.glsl: the dialect that all kernel code shares, for scalar number types.
// A number type R is float, double, NativeFloat or a wide float; its masks, integers and unsigned
// integers have one lane for each of its lanes. wide.h adds the same functions for wide floats.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "common/scene/layout.h"
#include "cpu/kernel/namespace.h"

TWINTRACE_KERNEL_BEGIN

using namespace layout;

/// A float for which the functions of math_native.h are chosen.
struct NativeFloat {
  float value = 0.0f;

  NativeFloat() = default;
  NativeFloat(float v) : value(v) {}
};
inline NativeFloat operator+(NativeFloat a, NativeFloat b) { return a.value + b.value; }
inline NativeFloat operator-(NativeFloat a, NativeFloat b) { return a.value - b.value; }
inline NativeFloat operator*(NativeFloat a, NativeFloat b) { return a.value * b.value; }
inline NativeFloat operator/(NativeFloat a, NativeFloat b) { return a.value / b.value; }
inline NativeFloat operator-(NativeFloat a) { return -a.value; }
inline bool operator<(NativeFloat a, NativeFloat b) { return a.value < b.value; }
inline bool operator>(NativeFloat a, NativeFloat b) { return a.value > b.value; }
inline bool operator<=(NativeFloat a, NativeFloat b) { return a.value <= b.value; }
inline bool operator>=(NativeFloat a, NativeFloat b) { return a.value >= b.value; }
inline bool operator==(NativeFloat a, NativeFloat b) { return a.value == b.value; }

/// What belongs to a number type: Mask, Int and Uint; Noise, the type in which random numbers are
/// computed (double arms draw the floats of float arms); Wider, the GLSL double of the kernel, which
/// holds a product of two numbers exactly, or for double has at least some digits more where the
/// platform does; native, whether its elementary functions are the standard library's.
template <class R>
struct NumberTraits;

template <class R, class NoiseType, class WiderType, bool isNative>
struct ScalarTraits {
  using Mask = bool;
  using Int = std::int32_t;
  using Uint = std::uint32_t;
  using Noise = NoiseType;
  using Wider = WiderType;
  static constexpr bool native = isNative;
};
template <>
struct NumberTraits<float> : ScalarTraits<float, float, double, false> {};
template <>
struct NumberTraits<double> : ScalarTraits<double, float, long double, true> {};
template <>
struct NumberTraits<NativeFloat> : ScalarTraits<NativeFloat, NativeFloat, double, true> {};

template <class R>
using MaskOf = typename NumberTraits<R>::Mask;
template <class R>
using IntOf = typename NumberTraits<R>::Int;
template <class R>
using UintOf = typename NumberTraits<R>::Uint;
template <class R>
using NoiseOf = typename NumberTraits<R>::Noise;
template <class R>
using WiderOf = typename NumberTraits<R>::Wider;
template <class R>
concept NativeNumber = NumberTraits<R>::native;
template <class R>
concept StrictNumber = !NumberTraits<R>::native;

/// The built-in number below a number type.
inline float plainNumber(float x) { return x; }
inline double plainNumber(double x) { return x; }
inline float plainNumber(NativeFloat x) { return x.value; }

/// A constant in the number type's own precision.
template <class R>
R constant(double value) {
  if constexpr (std::is_same_v<R, double>) {
    return value;
  } else {
    return R(static_cast<float>(value));
  }
}

/// A bound on float rounding, for double scaled by 2^-29, the ratio of the two precisions.
template <class R>
R errorBound(float bound) {
  return constant<R>(std::is_same_v<R, double> ? double{bound} * 0x1p-29 : double{bound});
}

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kLargest = std::numeric_limits<float>::max();

inline bool anyLane(bool condition) { return condition; }

inline float select(bool condition, float a, float b) { return condition ? a : b; }
inline double select(bool condition, double a, double b) { return condition ? a : b; }
inline NativeFloat select(bool condition, NativeFloat a, NativeFloat b) { return condition ? a : b; }
inline std::int32_t select(bool condition, std::int32_t a, std::int32_t b) {
  return condition ? a : b;
}
inline std::uint32_t select(bool condition, std::uint32_t a, std::uint32_t b) {
  return condition ? a : b;
}

/// The smaller value; a NaN in b is dropped, a NaN in a stays.
template <class R>
R least(R a, R b) {
  return select(b < a, b, a);
}

/// The larger value; a NaN in b is dropped, a NaN in a stays.
template <class R>
R greatest(R a, R b) {
  return select(b > a, b, a);
}

/// x held within [low, high]; NaN becomes low.
template <class R>
R clampTo(R x, R low, R high) {
  return least(greatest(low, x), high);
}

inline float absolute(float x) { return std::fabs(x); }
inline double absolute(double x) { return std::fabs(x); }
inline NativeFloat absolute(NativeFloat x) { return std::fabs(x.value); }

// Largest integer not above x. Written out since the baseline has no rounding instruction: floats of
// 2^23 and beyond are integers, smaller ones survive the conversion.
inline float floorOf(float x) {
  const float truncated = static_cast<float>(static_cast<std::int32_t>(
      std::fabs(x) < 8388608.0f ? x : 0.0f));
  const float lowered = x < truncated ? truncated - 1.0f : truncated;
  return std::fabs(x) < 8388608.0f ? lowered : x;
}
inline double floorOf(double x) { return std::floor(x); }
inline NativeFloat floorOf(NativeFloat x) { return floorOf(x.value); }

/// A number as a wider one, exactly.
inline double wider(float x) { return x; }
inline long double wider(double x) { return x; }
inline double wider(NativeFloat x) { return x.value; }

/// The nearest number to a wider one; infinity beyond the largest.
inline float nearestFloat(double x) { return static_cast<float>(x); }
template <class R>
R rounded(WiderOf<R> x) {
  if constexpr (std::is_same_v<R, double>) {
    return static_cast<double>(x);
  } else {
    return R(nearestFloat(x));
  }
}

/// a b - c d from exact products, so that its sign is exact.
template <class R>
WiderOf<R> differenceOfProducts(R a, R b, R c, R d) {
  return wider(a) * wider(b) - wider(c) * wider(d);
}
/// Kahan's: there is no type in which products of doubles are exact, but fused multiplication gives
/// what the rounded one lacks.
template <>
inline long double differenceOfProducts(double a, double b, double c, double d) {
  const double product = c * d;
  const double lacking = std::fma(-c, d, product);
  return wider(std::fma(a, b, -product)) + lacking;
}

inline float rootOf(float x) { return std::sqrt(x); }
inline double rootOf(double x) { return std::sqrt(x); }
inline long double rootOf(long double x) { return std::sqrt(x); }
inline NativeFloat rootOf(NativeFloat x) { return std::sqrt(x.value); }

/// Conversion towards zero; x in the range of int32.
inline std::int32_t toInt(float x) { return static_cast<std::int32_t>(x); }
inline std::int32_t toInt(double x) { return static_cast<std::int32_t>(x); }
inline std::int32_t toInt(NativeFloat x) { return static_cast<std::int32_t>(x.value); }

inline std::int32_t bitsOf(float x) { return std::bit_cast<std::int32_t>(x); }
inline float floatFromBits(std::int32_t bits) { return std::bit_cast<float>(bits); }

/// The float of those bits as an R. wide.h has the overload for wide bits.
template <class R>
R numberFromBits(std::uint32_t bits) {
  return R(std::bit_cast<float>(bits));
}

/// Exact for |x| <= 2^24.
template <class R>
R toNumber(std::int32_t x) {
  return R(static_cast<float>(x));
}
inline std::int32_t toSigned(std::uint32_t x) { return static_cast<std::int32_t>(x); }
inline std::uint32_t toUnsigned(std::int32_t x) { return static_cast<std::uint32_t>(x); }

/// A random number computed as NoiseOf<R>, as an R.
template <class R>
R widened(NoiseOf<R> x) {
  return R(x);
}
/// An R rounded to the type in which random numbers are computed.
template <class R>
NoiseOf<R> narrowed(R x) {
  if constexpr (std::is_same_v<R, NoiseOf<R>>) {
    return x;
  } else {
    return NoiseOf<R>(static_cast<float>(plainNumber(x)));
  }
}

TWINTRACE_KERNEL_END

#include "cpu/kernel/vec3.h"
