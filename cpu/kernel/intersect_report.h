#pragma once

// Twin of shaders/intersect_report.glsl: intersections as the report has them, faults included.
// Each returns the distance, or infinity for a miss; directions must be unit.

#include "cpu/kernel/ray.h"
#include "cpu/kernel/records.h"

TWINTRACE_KERNEL_BEGIN

/// Report algorithm 2.
template <class R>
R intersectSphereReport(const Ray<R>& ray, const Sphere<R>& sphere) {
  const R along = dot3(sphere.center - ray.origin, ray.direction);
  const Vec3<R> nearest = ray.origin + ray.direction * along;
  const R distance = length3(sphere.center - nearest);
  const R r = sphere.radius;
  const R halfChord = squareRoot(greatest(r * r - distance * distance, R(0.0f)));
  const R t = along - halfChord;
  const MaskOf<R> valid = distance < r && t > R(0.0f) && t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

/// Report eq. 3-5, algorithm 1.
template <class R>
R intersectBoxReport(const Ray<R>& ray, const Box<R>& box) {
  const Vec3<R> below = box.minimum - ray.origin;
  const Vec3<R> above = box.maximum - ray.origin;
  const Vec3<R> t0(divide(below.x, ray.direction.x), divide(below.y, ray.direction.y),
                   divide(below.z, ray.direction.z));
  const Vec3<R> t1(divide(above.x, ray.direction.x), divide(above.y, ray.direction.y),
                   divide(above.z, ray.direction.z));
  const Vec3<R> low(least(t0.x, t1.x), least(t0.y, t1.y), least(t0.z, t1.z));
  const Vec3<R> high(greatest(t0.x, t1.x), greatest(t0.y, t1.y), greatest(t0.z, t1.z));
  const R entry = greatest(R(-1e14f), largestComponent(low));
  const R exit = least(R(1e14f), least(least(high.x, high.y), high.z));
  const MaskOf<R> valid = entry >= R(0.0f) && entry <= exit && entry >= ray.tmin;
  return select(valid, entry, R(kInfinity));
}

/// Report eq. 7.
template <class R>
R intersectPlaneReport(const Ray<R>& ray, const Plane<R>& plane) {
  const R facing = dot3(plane.normal, ray.direction);
  const R t = divide(dot3(plane.point - ray.origin, plane.normal), facing);
  const R size = absolute(facing);
  const MaskOf<R> valid = size > R(1e-4f) && t >= R(1e-4f) && t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

TWINTRACE_KERNEL_END
