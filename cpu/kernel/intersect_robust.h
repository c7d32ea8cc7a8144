#pragma once

// Twin of shaders/intersect_robust.glsl: intersections that stay right far from the origin, at
// grazing angles, for any direction's length and from inside. Each returns the first distance
// t >= tmin, or infinity for a miss.

#include "cpu/kernel/ray.h"
#include "cpu/kernel/records.h"

TWINTRACE_KERNEL_BEGIN

/// 2 gamma(3): how far rounding can move a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
inline constexpr float kSlabWidening = 7.2e-7f;

/// How far the sphere's differences of squared lengths can err, as a part of their sum.
inline constexpr float kSphereDoubt = 9.5367431640625e-7f;
/// Squared lengths within which no product of the test overflows or loses bits to underflow.
inline constexpr float kLeastSquare = 1e-24f;
inline constexpr float kMostSquare = 1e36f;

/// Haines, Guenther and Akenine-Moeller 2019 (Ray Tracing Gems, ch. 7) in the wider number.
template <class R>
R intersectSphereInDouble(const Ray<R>& ray, const Sphere<R>& sphere) {
  using Wider = WiderOf<R>;
  const Vec3<Wider> d = wider3(ray.direction);
  const Vec3<Wider> f = wider3(ray.origin) - wider3(sphere.center);
  const Wider a = (d.x * d.x + d.y * d.y) + d.z * d.z;
  const Wider b = -((f.x * d.x + f.y * d.y) + f.z * d.z);
  const Vec3<Wider> toAxis = f + d * (b / a);
  const Wider r2 = wider(sphere.radius) * wider(sphere.radius);
  const Wider l2 = (toAxis.x * toAxis.x + toAxis.y * toAxis.y) + toAxis.z * toAxis.z;
  const Wider discriminant = r2 - l2;
  const Wider root = rootOf(a * discriminant);
  const Wider less = b - root;
  const Wider more = b + root;
  const Wider c = ((f.x * f.x + f.y * f.y) + f.z * f.z) - r2;
  const MaskOf<R> backwards = b < Wider(0.0f);
  const R t0 = select(backwards, rounded<R>(c / less), rounded<R>(c / more));
  const R t1 = select(backwards, rounded<R>(less / a), rounded<R>(more / a));
  const R first = least(t1, t0);
  const R second = greatest(t1, t0);
  const R t = select(first >= ray.tmin, first, second);
  const MaskOf<R> valid = discriminant >= Wider(0.0f) && t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

/// The same in R, and in the wider number where R cannot tell whether the ray touches the sphere, on
/// which side of it it begins, or where lengths have no squares. Most rays miss: what follows the
/// first test is the costly half. llvmpipe would run both sides of that branch.
/// @param ray its direction's largest component is within [0.5, 2).
template <class R>
R intersectSphereRobust(const Ray<R>& ray, const Sphere<R>& sphere) {
  const Vec3<R> f = ray.origin - sphere.center;
  const R a = dot3(ray.direction, ray.direction);
  const R b = -dot3(f, ray.direction);
  const Vec3<R> toAxis = f + ray.direction * divide(b, a);
  const R r2 = sphere.radius * sphere.radius;
  const R f2 = dot3(f, f);
  const R discriminant = r2 - dot3(toAxis, toAxis);
  const R c = f2 - r2;
  const R squares = f2 + r2;
  const R doubt = squares * R(kSphereDoubt);
  const MaskOf<R> passes = discriminant < -doubt;
  const MaskOf<R> sized = squares > R(kLeastSquare) && squares < R(kMostSquare);
  if (!anyLane(!(passes && sized))) return R(kInfinity);
  const MaskOf<R> meets = discriminant > doubt && absolute(c) > doubt;
  const MaskOf<R> sure = (passes || meets) && sized;
  const R root = squareRoot(a * discriminant);
  const R q = select(b < R(0.0f), b - root, b + root);
  const R t0 = divide(c, q);
  const R t1 = divide(q, a);
  const R first = least(t1, t0);
  const R second = greatest(t1, t0);
  const R t = select(first >= ray.tmin, first, second);
  const MaskOf<R> valid = meets && t >= ray.tmin;
  R result = select(valid, t, R(kInfinity));
  if (anyLane(!sure)) result = select(sure, result, intersectSphereInDouble(ray, sphere));
  return result;
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

/// t = num / den with no threshold on den, in the wider number, since in a nearly parallel ray's den
/// little is left of its terms: an exactly parallel ray gives infinity or NaN, which is a miss.
template <class R>
R intersectPlaneRobust(const Ray<R>& ray, const Plane<R>& plane) {
  using Wider = WiderOf<R>;
  const Vec3<Wider> n = wider3(plane.normal);
  const Vec3<Wider> d = wider3(ray.direction);
  const Vec3<Wider> toPlane = wider3(plane.point) - wider3(ray.origin);
  const Wider height = (toPlane.x * n.x + toPlane.y * n.y) + toPlane.z * n.z;
  const Wider facing = (d.x * n.x + d.y * n.y) + d.z * n.z;
  const R t = rounded<R>(height / facing);
  const MaskOf<R> valid = t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

TWINTRACE_KERNEL_END
