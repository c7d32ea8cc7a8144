#pragma once

// Twin of shaders/hulls/volumes/aabb.glsl: axis-aligned boxes. Where a ray enters a hull whose
// record begins at a texel; a lower bound of every t found inside, or infinity.

#include "cpu/kernel/hulls/hull_access.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
R enterAabb(const SceneView& scene, const HullRay<R>& ray, int record) {
  const Vec3<R> low = hullVector<R>(fetchHullTexel(scene, record));
  const Vec3<R> high = hullVector<R>(fetchHullTexel(scene, record + 1));
  return entryOf(withinSlabs(wholeRay(ray.ray), ray.axes, low, high));
}

TWINTRACE_KERNEL_END
