#pragma once

// Twin of shaders/hulls/volumes/kdop.glsl: discrete oriented polytopes. Where a ray enters a
// hull whose record begins at a texel; a lower bound of every t found inside, or infinity.

#include "cpu/kernel/hulls/hull_access.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
Interval<R> withinGroup(const SceneView& scene, const Interval<R>& given, const SlabGroup<R>& group,
                        int record) {
  return withinSlabs(given, group, hullVector<R>(fetchHullTexel(scene, record)),
                     hullVector<R>(fetchHullTexel(scene, record + 1)));
}

template <class R>
R enterKdop(const SceneView& scene, const HullRay<R>& ray, int record) {
  Interval<R> inside = withinGroup(scene, wholeRay(ray.ray), ray.axes, record);
  if (scene.hulls.groups > 1) inside = withinGroup(scene, inside, ray.second, record + 2);
  if (scene.hulls.groups > 2) inside = withinGroup(scene, inside, ray.third, record + 4);
  if (scene.hulls.groups > 3) inside = withinGroup(scene, inside, ray.fourth, record + 6);
  if (scene.hulls.groups > 4) inside = withinGroup(scene, inside, ray.fifth, record + 8);
  return entryOf(inside);
}

TWINTRACE_KERNEL_END
