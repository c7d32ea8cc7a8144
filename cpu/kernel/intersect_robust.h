#pragma once

// Twin of shaders/intersect_robust.glsl: intersections that stay right far from the origin, at
// grazing angles, for any direction's length and from inside. Each returns the first distance
// t >= tmin, or infinity for a miss.

#include "cpu/kernel/ray.h"
#include "cpu/kernel/records.h"

TWINTRACE_KERNEL_BEGIN

/// 2 gamma(3): how far rounding can move a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
inline constexpr float kSlabWidening = 7.2e-7f;

/// A ray's line seen from a sphere. `foot` is about the point of the line that is nearest to the
/// center, relative to the center and in radii; only `t` is in the ray's own units.
template <class R>
struct SphereLine {
  Vec3<R> foot;
  R t;        ///< the foot's distance from the ray's origin
  R ahead;    ///< step from the foot to the nearest point, times the direction's squared length
  R inverse;  ///< 1 / the direction's squared length
  R squared;  ///< quarter of the discriminant; below 0 for a line that misses
};

/// Where the line meets the sphere: as steps from the foot along the direction, in radii, and as
/// the ray's t. Without meaning for a line that misses.
template <class R>
struct SphereChord {
  R entryStep;
  R exitStep;
  R entry;
  R exit;
};

/// Haines, Guenther and Akenine-Moeller 2019 (Ray Tracing Gems, ch. 7), changed as in
/// shaders/intersect_robust.glsl: the line's point near the center is exact, from products in the wider
/// number; the rest is a unit sphere seen from close by.
template <class R>
SphereLine<R> lineThrough(const Ray<R>& ray, const Sphere<R>& sphere) {
  const Vec3<R>& d = ray.direction;
  const Vec3<R> f = ray.origin - sphere.center;
  const R a = dot3(d, d);
  const R inverse = divide(R(1.0f), a);
  const R t = -dot3(f, d) * inverse;
  const Vec3<WiderOf<R>> from = wider3(ray.origin) - wider3(sphere.center);
  // 1 / radius would be denormal for the largest radii, and flushed to zero; 4 / radius never is.
  const WiderOf<R> scale = wider(divide(R(4.0f), sphere.radius)) * WiderOf<R>(0.25f);
  const Vec3<WiderOf<R>> near = (from + wider3(d) * wider(t)) * scale;
  const Vec3<R> foot(rounded<R>(near.x), rounded<R>(near.y), rounded<R>(near.z));
  const R ahead = -dot3(foot, d);
  const R beyond = dot3(foot, foot) - R(1.0f);
  return {foot, t, ahead, inverse, ahead * ahead - a * beyond};
}

template <class R>
SphereChord<R> chordOf(const SphereLine<R>& line, R radius) {
  const R root = squareRoot(line.squared);
  const R entryStep = (line.ahead - root) * line.inverse;
  const R exitStep = (line.ahead + root) * line.inverse;
  return {entryStep, exitStep, line.t + entryStep * radius, line.t + exitStep * radius};
}

template <class R>
R intersectSphereRobust(const Ray<R>& ray, const Sphere<R>& sphere) {
  const SphereLine<R> line = lineThrough(ray, sphere);
  const MaskOf<R> meets = line.squared >= R(0.0f);
  if (!anyLane(meets)) return R(kInfinity);  // as most rays do
  const SphereChord<R> chord = chordOf(line, sphere.radius);
  const R t = select(chord.entry >= ray.tmin, chord.entry, chord.exit);
  return select(meets && t >= ray.tmin, t, R(kInfinity));
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
