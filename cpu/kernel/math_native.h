#pragma once

// Twin of shaders/math_native.glsl: the functions of math.h by the standard library, for NativeFloat
// and double.

#include "cpu/kernel/number.h"

TWINTRACE_KERNEL_BEGIN

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kInversePi = 0.31830988618379067154;
inline constexpr double kTwoPi = 6.28318530717958647692;
inline constexpr double kInverseTwoPi = 0.15915494309189533577;

template <NativeNumber R>
R divide(R a, R b) {
  return a / b;
}

template <NativeNumber R>
Vec3<R> divide(const Vec3<R>& a, R b) {
  return {a.x / b, a.y / b, a.z / b};
}

template <NativeNumber R>
R squareRoot(R x) {
  return rootOf(x);
}

template <NativeNumber R>
R dot3(const Vec3<R>& a, const Vec3<R>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <NativeNumber R>
Vec3<R> cross3(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <NativeNumber R>
R length3(const Vec3<R>& v) {
  return rootOf(dot3(v, v));
}

template <NativeNumber R>
Vec3<R> normalize3(const Vec3<R>& v) {
  return divide(v, length3(v));
}

template <NativeNumber R>
Vec3<R> reflect3(const Vec3<R>& d, const Vec3<R>& n) {
  return d - n * (R(2.0f) * dot3(d, n));
}

template <class R>
struct SinCos {
  R sine;
  R cosine;
};

template <NativeNumber R>
SinCos<R> sinCosTurns(R u) {
  const auto angle = plainNumber(constant<R>(kTwoPi) * u);
  return {R(std::sin(angle)), R(std::cos(angle))};
}

template <NativeNumber R>
R sine(R x) {
  return R(std::sin(plainNumber(x)));
}

template <NativeNumber R>
R log2Of(R x) {
  return R(std::log2(plainNumber(x)));
}

template <NativeNumber R>
R exp2Of(R x) {
  return R(std::exp2(plainNumber(x)));
}

template <NativeNumber R>
R power(R x, R y) {
  return x > R(0.0f) ? R(std::pow(plainNumber(x), plainNumber(y))) : R(0.0f);
}

template <NativeNumber R>
R arcTangent2(R y, R x) {
  return R(std::atan2(plainNumber(y), plainNumber(x)));
}

template <NativeNumber R>
R arcCosine(R x) {
  return R(std::acos(plainNumber(clampTo(x, R(-1.0f), R(1.0f)))));
}

TWINTRACE_KERNEL_END
