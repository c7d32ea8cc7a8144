#pragma once

// Twin of shaders/hulls/volumes/aabbSphere.glsl: a box and a sphere, tested one after the other.

#include "cpu/kernel/hulls/volumes/aabb.h"
#include "cpu/kernel/hulls/volumes/sphere.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
R enterAabbSphere(const SceneView& scene, const HullRay<R>& ray, int record) {
  const R box = enterAabb(scene, ray, record);
  const MaskOf<R> enters = box <= R(kLargest);
  if (!anyLane(enters)) return box;
  const R sphere = enterSphere(scene, ray, record + 2);
  return select(enters, greatest(box, sphere), box);
}

TWINTRACE_KERNEL_END
