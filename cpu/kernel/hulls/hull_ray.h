#pragma once

// Twin of shaders/hulls/hull_ray.glsl: a ray as hulls see it, prepared once, and why hulls are widened.

#include "cpu/kernel/intersect.h"

TWINTRACE_KERNEL_BEGIN

/// 64 ulp: see shaders/hulls/hull_ray.glsl.
inline constexpr float kHullSlack = 0x1p-17f;

/// Three slabs' normals n along a ray: n . o moved back and forth by the slack, and 1 / (n . d), with
/// +infinity for 0.
template <class R>
struct SlabGroup {
  Vec3<R> nearAlong;
  Vec3<R> farAlong;
  Vec3<R> inverse;
};

template <class R>
struct HullRay {
  Ray<R> ray;
  R slack;
  SlabGroup<R> axes;
  SlabGroup<R> second;  ///< the further normals of k-DOPs, see slabCoordinates
  SlabGroup<R> third;
  SlabGroup<R> fourth;
  SlabGroup<R> fifth;
};

/// The distances along a ray over which it may be inside.
template <class R>
struct Interval {
  R entry;
  R exit;
};

/// n . v for the three normals n of a group: see shaders/hulls/hull_ray.glsl.
template <class R>
Vec3<R> slabCoordinates(int group, const Vec3<R>& v) {
  if (group == 1) {
    const R xy = v.x + v.y;
    return {xy + v.z, xy - v.z, (v.x - v.y) + v.z};
  }
  if (group == 2) return {(v.y - v.x) + v.z, v.x + v.y, v.x - v.y};
  if (group == 3) return {v.x + v.z, v.x - v.z, v.y + v.z};
  if (group == 4) {
    const R last = v.y - v.z;
    return {last, last, last};
  }
  return v;
}

template <class R>
SlabGroup<R> slabGroup(int group, const Ray<R>& ray, R slack) {
  const R zero(0.0f);
  const Vec3<R> along = slabCoordinates(group, ray.origin);
  const Vec3<R> d = slabCoordinates(group, ray.direction);
  const R wide = R(3.0f) * slack;
  const R reach = group == 0 ? slack : wide;
  const Vec3<R> back(select(d.x < zero, -reach, reach), select(d.y < zero, -reach, reach),
                     select(d.z < zero, -reach, reach));
  const Vec3<R> inverse = group == 0 ? ray.inverse : makeRay(along, d, zero, zero).inverse;
  return {along + back, along - back, inverse};
}

/// How far a coordinate may be off.
template <class R>
R hullSlack(const SceneView& scene, const Ray<R>& ray) {
  const Vec3<R> size(absolute(ray.origin.x), absolute(ray.origin.y), absolute(ray.origin.z));
  return greatest(R(scene.hulls.reach), largestComponent(size)) * R(kHullSlack);
}

template <class R>
HullRay<R> prepareHulls(const SceneView& scene, const Ray<R>& ray) {
  const int groups = scene.hulls.groups;
  const R slack = hullSlack(scene, ray);
  const SlabGroup<R> axes = slabGroup(0, ray, slack);
  HullRay<R> result{ray, slack, axes, axes, axes, axes, axes};
  if (groups > 1) result.second = slabGroup(1, ray, slack);
  if (groups > 2) result.third = slabGroup(2, ray, slack);
  if (groups > 3) result.fourth = slabGroup(3, ray, slack);
  if (groups > 4) result.fifth = slabGroup(4, ray, slack);
  return result;
}

/// The part of an interval within three slabs; NaN, of a ray in a slab's plane, limits nothing.
template <class R>
Interval<R> withinSlabs(const Interval<R>& given, const SlabGroup<R>& group, const Vec3<R>& low,
                        const Vec3<R>& high) {
  const R zero(0.0f);
  const MaskOf<R> backX = group.inverse.x < zero;
  const MaskOf<R> backY = group.inverse.y < zero;
  const MaskOf<R> backZ = group.inverse.z < zero;
  const Vec3<R> first(select(backX, high.x, low.x), select(backY, high.y, low.y),
                      select(backZ, high.z, low.z));
  const Vec3<R> last(select(backX, low.x, high.x), select(backY, low.y, high.y),
                     select(backZ, low.z, high.z));
  const Vec3<R> near = (first - group.nearAlong) * group.inverse;
  const Vec3<R> far = (last - group.farAlong) * group.inverse;
  return {greatest(greatest(greatest(given.entry, near.x), near.y), near.z),
          least(least(least(given.exit, far.x), far.y), far.z)};
}

/// Where a ray enters: the interval's start, or infinity for an empty one. An end that is NaN, of
/// numbers too large for floats, excludes nothing.
template <class R>
R entryOf(const Interval<R>& interval) {
  return select(interval.entry > interval.exit, R(kInfinity), interval.entry);
}

template <class R>
Interval<R> wholeRay(const Ray<R>& ray) {
  return {ray.tmin, computedInfinity(ray)};
}

TWINTRACE_KERNEL_END
