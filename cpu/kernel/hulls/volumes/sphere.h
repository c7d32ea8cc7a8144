#pragma once

// Twin of shaders/hulls/volumes/sphere.glsl: spheres. Where a ray enters a hull whose record
// begins at a texel; a lower bound of every t found inside, or infinity.

#include "cpu/kernel/hulls/hull_access.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
R enterSphere(const SceneView& scene, const HullRay<R>& ray, int record) {
  const glm::uvec4 ball = fetchHullTexel(scene, record);
  const Vec3<R>& d = ray.ray.direction;
  const Vec3<R> f = ray.ray.origin - hullVector<R>(ball);
  const R inverse = divide(R(1.0f), dot3(d, d));
  const R t = -dot3(f, d) * inverse;
  const Vec3<R> nearest = f + d * t;
  const R radius = numberFromBits<R>(ball.w) + R(2.0f) * ray.slack;
  const R halfChordSquared = (radius * radius - dot3(nearest, nearest)) * inverse;
  const R halfChord = squareRoot(halfChordSquared);
  const Interval<R> inside{greatest(ray.ray.tmin, t - halfChord), t + halfChord};
  return select(halfChordSquared < R(0.0f), R(kInfinity), entryOf(inside));
}

TWINTRACE_KERNEL_END
