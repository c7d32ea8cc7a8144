#pragma once

// Twin of shaders/hulls/volumes/obb.glsl: oriented boxes. Where a ray enters a hull whose record
// begins at a texel; a lower bound of every t found inside, or infinity.

#include "cpu/kernel/hulls/hull_access.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
R enterObb(const SceneView& scene, const HullRay<R>& ray, int record) {
  const OrientedBox<R> box{hullVector<R>(fetchHullTexel(scene, record)),
                           hullVector<R>(fetchHullTexel(scene, record + 1)),
                           hullVector<R>(fetchHullTexel(scene, record + 2)),
                           hullVector<R>(fetchHullTexel(scene, record + 3)),
                           hullVector<R>(fetchHullTexel(scene, record + 4))};
  const Ray<R> local = toLocalRay(ray.ray, box);
  const R slack = R(3.0f) * ray.slack;
  const SlabGroup<R> axes = slabGroup(0, local, slack);
  return entryOf(withinSlabs(wholeRay(local), axes, -box.halfSize, box.halfSize));
}

TWINTRACE_KERNEL_END
