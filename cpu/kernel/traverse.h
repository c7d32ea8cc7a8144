#pragma once

// Twin of shaders/traverse.glsl: queries against the whole scene.

#include "cpu/kernel/geometry.h"

TWINTRACE_KERNEL_BEGIN

/// The answer of the scene's hull structure, ray by ray. wide.h has the overload for wide rays.
template <class R>
Hit<R> queryHull(const SceneView& scene, const Ray<R>& ray) {
  const auto floatOf = [](R x) { return static_cast<float>(plainNumber(x)); };
  const float origin[3] = {floatOf(ray.origin.x), floatOf(ray.origin.y), floatOf(ray.origin.z)};
  const float direction[3] = {floatOf(ray.direction.x), floatOf(ray.direction.y),
                              floatOf(ray.direction.z)};
  float t = 0.0f;
  const int primitive =
      scene.hull->closest(origin, direction, floatOf(ray.tmin), floatOf(ray.tmax), t);
  return {primitive == kNoPrimitive ? ray.tmax : R(t), primitive};
}

/// Smallest t within the ray's closed interval, ties to the lowest primitive.
template <class R>
Hit<R> closestHit(const SceneView& scene, const Ray<R>& ray) {
  if (scene.hull != nullptr) return queryHull(scene, ray);
  return visitGeometry(scene, ray, Hit<R>{ray.tmax, IntOf<R>(kNoPrimitive)});
}

/// Whether anything lies within the ray's interval.
template <class R>
MaskOf<R> occluded(const SceneView& scene, const Ray<R>& ray) {
  return closestHit(scene, ray).primitive != IntOf<R>(kNoPrimitive);
}

TWINTRACE_KERNEL_END
