#pragma once

// Twin of shaders/path.glsl: unbiased path tracing; emission is found by hitting it, local lights
// are sampled at every vertex. Kajiya 1986.

#include "cpu/kernel/light.h"
#include "cpu/kernel/material.h"
#include "cpu/kernel/vertex.h"

TWINTRACE_KERNEL_BEGIN

/// Light of all local lights reflected at a vertex along -d.
template <class R>
Vec3<R> directLight(const SceneView& scene, const Vertex<R>& vertex, const Vec3<R>& d,
                    const Reflectance<R>& material, const SampleKey<R>& key, IntOf<R> bounce) {
  Vec3<R> sum;
  for (int i = 0; i < scene.index.lightCount; ++i) {
    const int dimension = kDimensionLight + i * kDimensionsPerLight;
    const R u = noise<R>(scene, key, bounce, dimension);
    const R v = noise<R>(scene, key, bounce, dimension + 1);
    const LightSample<R> light = sampleLight(scene, fetchLight<R>(scene, i), vertex.origin, u, v);
    const Vec3<R> reflected =
        evaluateReflectance(scene, material, vertex.normal, d, light.direction) * light.value;
    const MaskOf<R> blocked = isBlocked(scene, vertex, light.direction, light.distance);
    sum = sum + select(blocked, Vec3<R>(), reflected);
  }
  return sum;
}

/// One vertex: the light found there, and the next ray.
template <class R>
PathState<R> stepPath(const SceneView& scene, const PathState<R>& state, const Frame& frame) {
  const Vertex<R> vertex = arrive(scene, state, frame);
  Vec3<R> radiance = vertex.radiance;
  if (!anyLane(vertex.scatters)) return stop(state, radiance);
  const Vec3<R>& d = state.ray.direction;
  if (scene.effectAnyLight()) {
    const Vec3<R> direct =
        directLight(scene, vertex, d, fetchReflectance<R>(scene, vertex.material), state.key,
                    state.bounce);
    radiance = withLight(vertex, state.throughput, direct);
  }
  const ScatterSample<R> next = sampleScattering(
      scene, fetchScattering<R>(scene, vertex.material), vertex.normal, d,
      noise<R>(scene, state.key, state.bounce, kDimensionLobe),
      noise<R>(scene, state.key, state.bounce, kDimensionDirectionU),
      noise<R>(scene, state.key, state.bounce, kDimensionDirectionV));
  return leave(scene, state, vertex, radiance, next.direction, next.weight);
}

TWINTRACE_KERNEL_END
