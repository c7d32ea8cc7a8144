#pragma once

#include "cpu/kernel/number.h"

TWINTRACE_KERNEL_BEGIN

/// Three numbers; the GLSL vec3 of the kernel, with the same component-wise operators.
template <class R>
struct Vec3 {
  R x, y, z;

  Vec3() : x(0.0f), y(0.0f), z(0.0f) {}
  explicit Vec3(R all) : x(all), y(all), z(all) {}
  Vec3(R x_, R y_, R z_) : x(x_), y(y_), z(z_) {}

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(const Vec3& a, const Vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Vec3 operator*(const Vec3& a, R b) { return {a.x * b, a.y * b, a.z * b}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
};

template <class R>
Vec3<R> select(MaskOf<R> condition, const Vec3<R>& a, const Vec3<R>& b) {
  return {select(condition, a.x, b.x), select(condition, a.y, b.y), select(condition, a.z, b.z)};
}

template <class R>
Vec3<WiderOf<R>> wider3(const Vec3<R>& v) {
  return {wider(v.x), wider(v.y), wider(v.z)};
}

template <class R>
R largestComponent(const Vec3<R>& v) {
  return greatest(greatest(v.x, v.y), v.z);
}

TWINTRACE_KERNEL_END
