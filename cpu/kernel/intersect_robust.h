#pragma once

// Twin of shaders/intersect_robust.glsl: intersections that stay right far from the origin, at
// grazing angles, for any direction's length and from inside. Each returns the first distance
// t >= tmin, or infinity for a miss.

#include "cpu/kernel/ray.h"
#include "cpu/kernel/records.h"

TWINTRACE_KERNEL_BEGIN

/// 2 gamma(3): how far rounding can move a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
inline constexpr float kSlabWidening = 7.2e-7f;

/// A ray's line seen from a sphere: relative to the center and in radii, but for `t`.
template <class R>
struct SphereLine {
  Vec3<R> nearest;  ///< the line's point nearest to the center
  R t;              ///< the ray's t at a point of the line near that one
  R ahead;          ///< step along the direction from there to the nearest point
  R halfChordSquared;  ///< squared step from the nearest point to either hit; below 0 for a miss
};

/// Where the line meets the sphere: the step from the nearest point to either hit, and the hits' t.
/// Without meaning for a line that misses.
template <class R>
struct SphereChord {
  R halfChord;
  R entry;
  R exit;
};

/// Haines, Guenther and Akenine-Moeller 2019 (Ray Tracing Gems, ch. 7), changed as in
/// shaders/intersect_robust.glsl: a point of the line near the center is rounded once, from
/// products in the wider number; from there on the sphere is a unit sphere seen from close by.
/// @param ray its direction's largest component is within [0.5, 2).
/// @param sphere never hit if its radius is 0.
template <class R>
SphereLine<R> sphereLineOf(const Ray<R>& ray, const Sphere<R>& sphere) {
  const Vec3<R>& d = ray.direction;
  const Vec3<R> f = ray.origin - sphere.center;
  const R inverse = divide(R(1.0f), dot3(d, d));
  const R t = -dot3(f, d) * inverse;
  const Vec3<WiderOf<R>> from = wider3(ray.origin) - wider3(sphere.center);
  // 1 / radius would be denormal for the largest radii, and flushed to zero; 4 / radius never is.
  const R scale = divide(R(4.0f), sphere.radius);
  const Vec3<WiderOf<R>> exact = from + wider3(d) * wider(t);
  const Vec3<R> close(rounded<R>(exact.x), rounded<R>(exact.y), rounded<R>(exact.z));
  const Vec3<R> foot = (close * scale) * R(0.25f);
  const R ahead = -dot3(foot, d) * inverse;
  const Vec3<R> nearest = foot + d * ahead;
  return {nearest, t, ahead, (R(1.0f) - dot3(nearest, nearest)) * inverse};
}

template <class R>
SphereChord<R> chordOf(const SphereLine<R>& line, R radius) {
  const R halfChord = squareRoot(line.halfChordSquared);
  return {halfChord, line.t + (line.ahead - halfChord) * radius,
          line.t + (line.ahead + halfChord) * radius};
}

template <class R>
R intersectSphereRobust(const Ray<R>& ray, const Sphere<R>& sphere) {
  const SphereLine<R> line = sphereLineOf(ray, sphere);
  const MaskOf<R> meets = line.halfChordSquared >= R(0.0f);
  if (!anyLane(meets)) return R(kInfinity);  // as most rays do
  const SphereChord<R> chord = chordOf(line, sphere.radius);
  const R t = select(chord.entry >= ray.tmin, chord.entry, chord.exit);
  return select(meets && t >= ray.tmin, t, R(kInfinity));
}

/// Distances along a ray to the planes of a box's slabs, and the interval between the last that
/// enters and the first that leaves.
template <class R>
struct Slabs {
  Vec3<R> near;
  Vec3<R> far;
  R entry;
  R exit;
};

/// Infinity, for any ray: see shaders/intersect_robust.glsl for why it is a function.
template <class R>
R computedInfinity(const Ray<R>& ray) {
  static_cast<void>(ray);
  return R(kInfinity);
}

/// Kay and Kajiya 1986; near and far plane by the direction's sign, zero components by an infinite
/// inverse whose NaN on a face is dropped.
template <class R>
Slabs<R> slabsOf(const Ray<R>& ray, const Box<R>& box) {
  const MaskOf<R> backX = ray.direction.x < R(0.0f);
  const MaskOf<R> backY = ray.direction.y < R(0.0f);
  const MaskOf<R> backZ = ray.direction.z < R(0.0f);
  const Vec3<R> first(select(backX, box.maximum.x, box.minimum.x),
                      select(backY, box.maximum.y, box.minimum.y),
                      select(backZ, box.maximum.z, box.minimum.z));
  const Vec3<R> last(select(backX, box.minimum.x, box.maximum.x),
                     select(backY, box.minimum.y, box.maximum.y),
                     select(backZ, box.minimum.z, box.maximum.z));
  const Vec3<R> near = (first - ray.origin) * ray.inverse;
  const Vec3<R> far = (last - ray.origin) * ray.inverse;
  const R unbounded = computedInfinity(ray);
  const R entry = greatest(greatest(greatest(-unbounded, near.x), near.y), near.z);
  const R exit = least(least(least(unbounded, far.x), far.y), far.z);
  return {near, far, entry, exit};
}

template <class R>
R intersectBoxRobust(const Ray<R>& ray, const Box<R>& box) {
  const Slabs<R> slabs = slabsOf(ray, box);
  const R widened = slabs.exit * (R(1.0f) + errorBound<R>(kSlabWidening));
  const R t = select(slabs.entry < ray.tmin, slabs.exit, slabs.entry);
  const MaskOf<R> valid = slabs.entry <= widened && t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

/// t = num / den with no threshold on den, in the wider number, since in a nearly parallel ray's
/// den little is left of its terms: an exactly parallel ray gives infinity or NaN, which is a miss.
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
