#pragma once

// Twin of shaders/primitive.glsl: one primitive of the texel array, of whatever kind.

#include "cpu/kernel/intersect.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

/// The distance to a primitive that has bounds, or infinity; the same primitive in all lanes.
template <class R>
R intersectPrimitive(const SceneView& scene, const Ray<R>& ray, int primitive) {
  const int box = primitive - scene.index.sphereCount;
  const int orientedBox = box - scene.index.boxCount;
  const int triangle = orientedBox - scene.index.orientedBoxCount;
  if (scene.effectSphere && box < 0) {
    return intersectSphere(scene, ray, fetchSphere<R>(scene, primitive));
  }
  if (scene.effectBox && box >= 0 && orientedBox < 0) {
    return intersectBox(scene, ray, fetchBox<R>(scene, box));
  }
  if (scene.effectOrientedBox && orientedBox >= 0 && triangle < 0) {
    return intersectOrientedBox(scene, ray, fetchOrientedBox<R>(scene, orientedBox));
  }
  if (scene.effectTriangle && triangle >= 0) {
    return intersectTriangle(scene, ray, fetchTriangle<R>(scene, triangle));
  }
  return R(kInfinity);
}

TWINTRACE_KERNEL_END
