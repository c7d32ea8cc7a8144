// A ray as hulls see it, prepared once: what it has in common for all of them.
//
// Hulls contain their primitives, but a primitive's float test may find a t a little before its hull's
// entry. So hulls are widened by an absolute slack that covers the rounding of both tests: 64 ulp of the
// largest coordinate involved, where spheres may need 53 (cpu/embree_hull.cpp has the bounds).
#pragma once

#include "intersect.glsl"

// 64 ulp: 2^-17.
const float kHullSlack = 7.62939453125e-6f;

// Three slabs' normals n along a ray: n . o moved back and forth by the slack, and 1 / (n . d), with
// +infinity for 0.
struct SlabGroup {
  vec3 nearAlong;
  vec3 farAlong;
  vec3 inverse;
};

struct HullRay {
  Ray ray;
  float slack;
  SlabGroup axes;
  SlabGroup second;  // the further normals of k-DOPs, see slabCoordinates
  SlabGroup third;
  SlabGroup fourth;
  SlabGroup fifth;
};

// The distances along a ray over which it may be inside.
struct Interval {
  float entry;
  float exit;
};

// n . v for the three normals n of a group, not unit: the axes; three diagonals of the cube; its fourth
// and two of its faces' diagonals; three more of those; the last and, to fill the group, it again.
// Kay and Kajiya 1986 take the first seven.
vec3 slabCoordinates(int group, vec3 v) {
  precise vec3 result = v;
  if (group == 1) {
    precise float xy = v.x + v.y;
    precise float across = v.x - v.y;
    result = vec3(xy + v.z, xy - v.z, across + v.z);
  } else if (group == 2) {
    precise float across = v.y - v.x;
    result = vec3(across + v.z, v.x + v.y, v.x - v.y);
  } else if (group == 3) {
    result = vec3(v.x + v.z, v.x - v.z, v.y + v.z);
  } else if (group == 4) {
    precise float last = v.y - v.z;
    result = vec3(last, last, last);
  }
  return result;
}

SlabGroup slabGroup(int group, Ray ray, float slack) {
  precise vec3 along = slabCoordinates(group, ray.origin);
  precise vec3 d = slabCoordinates(group, ray.direction);
  // A plane's distance moves by the slack in each of up to three coordinates.
  precise float wide = 3.0f * slack;
  precise float reach = select(group == 0, slack, wide);
  precise vec3 back = vec3(select(d.x < 0.0f, -reach, reach), select(d.y < 0.0f, -reach, reach),
                           select(d.z < 0.0f, -reach, reach));
  precise vec3 inverse = select(group == 0, ray.inverse, makeRay(along, d, 0.0f, 0.0f).inverse);
  precise SlabGroup result = SlabGroup(along + back, along - back, inverse);
  return result;
}

// How far a coordinate may be off.
float hullSlack(Ray ray) {
  precise vec3 size = vec3(absolute(ray.origin.x), absolute(ray.origin.y), absolute(ray.origin.z));
  precise float slack = greatest(hullReach, largestComponent(size)) * kHullSlack;
  return slack;
}

HullRay prepareHulls(Ray ray) {
  precise float slack = hullSlack(ray);
  precise SlabGroup axes = slabGroup(0, ray, slack);
  precise HullRay result = HullRay(ray, slack, axes, axes, axes, axes, axes);
  if (kHullGroups > 1) {
    result.second = slabGroup(1, ray, slack);
  }
  if (kHullGroups > 2) {
    result.third = slabGroup(2, ray, slack);
  }
  if (kHullGroups > 3) {
    result.fourth = slabGroup(3, ray, slack);
  }
  if (kHullGroups > 4) {
    result.fifth = slabGroup(4, ray, slack);
  }
  return result;
}

// The part of an interval within three slabs; NaN, of a ray in a slab's plane, limits nothing.
Interval withinSlabs(Interval given, SlabGroup group, vec3 low, vec3 high) {
  precise bool backX = group.inverse.x < 0.0f;
  precise bool backY = group.inverse.y < 0.0f;
  precise bool backZ = group.inverse.z < 0.0f;
  precise vec3 first = vec3(select(backX, high.x, low.x), select(backY, high.y, low.y),
                            select(backZ, high.z, low.z));
  precise vec3 last = vec3(select(backX, low.x, high.x), select(backY, low.y, high.y),
                           select(backZ, low.z, high.z));
  precise vec3 near = (first - group.nearAlong) * group.inverse;
  precise vec3 far = (last - group.farAlong) * group.inverse;
  precise float entry = greatest(greatest(greatest(given.entry, near.x), near.y), near.z);
  precise float exit = least(least(least(given.exit, far.x), far.y), far.z);
  precise Interval result = Interval(entry, exit);
  return result;
}

// Where a ray enters: the interval's start, or infinity for an empty one. An end that is NaN, of numbers
// too large for floats, excludes nothing.
float entryOf(Interval interval) {
  precise float result = select(interval.entry > interval.exit, kInfinity, interval.entry);
  return result;
}

// Computed, so that llvmpipe makes minima of what follows: see computedInfinity.
Interval wholeRay(Ray ray) {
  precise Interval result = Interval(ray.tmin, computedInfinity(ray));
  return result;
}
