#pragma once

// Twin of shaders/ray.glsl: rays, hits and the total order among hits.

#include "cpu/kernel/math.h"

TWINTRACE_KERNEL_BEGIN

/// A ray with a closed interval; `inverse` is 1 / direction, +infinity for a zero component.
template <class R>
struct Ray {
  Vec3<R> origin;
  Vec3<R> direction;
  Vec3<R> inverse;
  R tmin;
  R tmax;
};

/// Closest hit so far; primitive is kNoPrimitive for a miss.
template <class R>
struct Hit {
  R t;
  IntOf<R> primitive;
};

template <class R>
R inverseOrInfinity(R x) {
  return select(x == R(0.0f), R(kInfinity), divide(R(1.0f), x));
}

template <class R>
Ray<R> makeRay(const Vec3<R>& origin, const Vec3<R>& direction, R tmin, R tmax) {
  const Vec3<R> inverse(inverseOrInfinity(direction.x), inverseOrInfinity(direction.y),
                        inverseOrInfinity(direction.z));
  return {origin, direction, inverse, tmin, tmax};
}

template <class R>
Vec3<R> pointAt(const Ray<R>& ray, R t) {
  return ray.origin + ray.direction * t;
}

/// The better of the best hit and a candidate: smaller t, then lower primitive.
/// @param t infinity for a candidate that misses.
template <class R>
Hit<R> nearer(const Hit<R>& best, R t, IntOf<R> primitive) {
  const MaskOf<R> closer = t < best.t || (t == best.t && primitive < best.primitive);
  return {select(closer, t, best.t), select(closer, primitive, best.primitive)};
}

TWINTRACE_KERNEL_END
