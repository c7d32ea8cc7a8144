#pragma once

// Twin of shaders/traverse.glsl: queries against the whole scene.

#include "cpu/kernel/geometry.h"

TWINTRACE_KERNEL_BEGIN

/// The answer of the scene's hulls. wide.h has the overload for wide rays.
template <class R>
Hit<R> queryHull(const SceneView& scene, const Ray<R>& ray) {
  using Number = decltype(plainNumber(ray.tmin));
  const auto plain = [](R x) { return plainNumber(x); };
  const HullQueryRay<Number> query{
      {plain(ray.origin.x), plain(ray.origin.y), plain(ray.origin.z)},
      {plain(ray.direction.x), plain(ray.direction.y), plain(ray.direction.z)},
      plain(ray.tmin),
      plain(ray.tmax)};
  Number t = 0;
  const int primitive = scene.hull->closest(query, t);
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
