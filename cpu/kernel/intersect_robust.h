#pragma once

// Twin of shaders/intersect_robust.glsl: intersections that stay right far from the origin, at
// grazing angles, for any direction's length and from inside. Each returns the first distance
// t >= tmin, or infinity for a miss.

#include "cpu/kernel/ray.h"
#include "cpu/kernel/records.h"

TWINTRACE_KERNEL_BEGIN

/// 2 gamma(3): how far rounding can move a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
inline constexpr float kSlabWidening = 7.2e-7f;

/// Haines, Guenther and Akenine-Moeller 2019 (Ray Tracing Gems, ch. 7), for directions of any length.
/// Changed: written in select form; the quotient that is 0/0 for an origin at the point of contact
/// is dropped by `least`.
template <class R>
R intersectSphereRobust(const Ray<R>& ray, const Sphere<R>& sphere) {
  const Vec3<R> f = ray.origin - sphere.center;
  const R a = dot3(ray.direction, ray.direction);
  const R b = -dot3(f, ray.direction);
  const Vec3<R> toAxis = f + ray.direction * divide(b, a);
  const R r2 = sphere.radius * sphere.radius;
  const R discriminant = r2 - dot3(toAxis, toAxis);
  // Most rays miss: what follows is the costly half. llvmpipe would run both sides of the branch.
  if (!anyLane(discriminant >= R(0.0f))) return R(kInfinity);
  const R root = squareRoot(a * greatest(discriminant, R(0.0f)));
  const R q = select(b < R(0.0f), b - root, b + root);
  const R c = dot3(f, f) - r2;
  const R t0 = divide(c, q);
  const R t1 = divide(q, a);
  const R first = least(t1, t0);
  const R second = greatest(t1, t0);
  const R t = select(first >= ray.tmin, first, second);
  const MaskOf<R> valid = discriminant >= R(0.0f) && t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

/// Kay and Kajiya 1986 slabs; near and far plane by the direction's sign, zero components by an
/// infinite inverse whose NaN on a face is dropped.
template <class R>
R intersectBoxRobust(const Ray<R>& ray, const Box<R>& box) {
  const MaskOf<R> backX = ray.direction.x < R(0.0f);
  const MaskOf<R> backY = ray.direction.y < R(0.0f);
  const MaskOf<R> backZ = ray.direction.z < R(0.0f);
  const R nearX = (select(backX, box.maximum.x, box.minimum.x) - ray.origin.x) * ray.inverse.x;
  const R nearY = (select(backY, box.maximum.y, box.minimum.y) - ray.origin.y) * ray.inverse.y;
  const R nearZ = (select(backZ, box.maximum.z, box.minimum.z) - ray.origin.z) * ray.inverse.z;
  const R farX = (select(backX, box.minimum.x, box.maximum.x) - ray.origin.x) * ray.inverse.x;
  const R farY = (select(backY, box.minimum.y, box.maximum.y) - ray.origin.y) * ray.inverse.y;
  const R farZ = (select(backZ, box.minimum.z, box.maximum.z) - ray.origin.z) * ray.inverse.z;
  const R entry = greatest(greatest(greatest(R(-kInfinity), nearX), nearY), nearZ);
  const R exit = least(least(least(R(kInfinity), farX), farY), farZ);
  const R widened = exit * (R(1.0f) + errorBound<R>(kSlabWidening));
  const R t = select(entry < ray.tmin, exit, entry);
  const MaskOf<R> valid = entry <= widened && t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

/// t = num / den with no threshold on den: a parallel ray gives infinity or NaN, which is a miss.
template <class R>
R intersectPlaneRobust(const Ray<R>& ray, const Plane<R>& plane) {
  const R height = dot3(plane.point - ray.origin, plane.normal);
  const R t = divide(height, dot3(plane.normal, ray.direction));
  const MaskOf<R> valid = t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

TWINTRACE_KERNEL_END
