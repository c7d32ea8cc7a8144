#pragma once

// Twin of shaders/whitted.glsl: integrators `local` (eq. 1) and `whitted` (eq. 2).

#include "cpu/kernel/light.h"
#include "cpu/kernel/vertex.h"

TWINTRACE_KERNEL_BEGIN

/// Eq. 1 without k_e. Changed: the visibility g belongs to each light, not to the whole sum.
template <class R>
Vec3<R> localIllumination(const SceneView& scene, const Vertex<R>& vertex, const Vec3<R>& d,
                          const LocalShading<R>& material, const SampleKey<R>& key,
                          IntOf<R> bounce) {
  Vec3<R> sum = material.ambient * fetchEnvironmentRadiance<R>(scene);
  for (int i = 0; i < scene.index.lightCount; ++i) {
    const int dimension = kDimensionLight + i * kDimensionsPerLight;
    const R u = noise<R>(scene, key, bounce, dimension);
    const R v = noise<R>(scene, key, bounce, dimension + 1);
    const LightSample<R> light = sampleLight(scene, fetchLight<R>(scene, i), vertex.origin, u, v);
    const Vec3<R> halfway = normalize3(light.direction - d);
    const R lambert = greatest(dot3(vertex.normal, light.direction), R(0.0f));
    const R highlight = power(dot3(halfway, vertex.normal), material.exponent);
    const Vec3<R> diffuse = material.albedo * lambert;
    const Vec3<R> shaded = (diffuse + material.highlight * highlight) * light.value;
    const MaskOf<R> faces = lambert > R(0.0f);
    const MaskOf<R> blocked = isBlocked(scene, vertex, light.direction, light.distance);
    sum = sum + select(faces && !blocked, shaded, Vec3<R>());
  }
  return sum;
}

template <class R>
PathState<R> stepLocal(const SceneView& scene, const PathState<R>& state, const Frame& frame) {
  const Vertex<R> vertex = arrive(scene, state, frame);
  Vec3<R> radiance = vertex.radiance;
  if (anyLane(vertex.scatters)) {
    const Vec3<R> local =
        localIllumination(scene, vertex, state.ray.direction,
                          fetchLocalShading<R>(scene, vertex.material), state.key, state.bounce);
    radiance = withLight(vertex, state.throughput, local);
  }
  return stop(state, radiance);
}

template <class R>
PathState<R> stepWhitted(const SceneView& scene, const PathState<R>& state, const Frame& frame) {
  const Vertex<R> vertex = arrive(scene, state, frame);
  if (!anyLane(vertex.scatters)) return stop(state, vertex.radiance);
  const Vec3<R>& d = state.ray.direction;
  const Vec3<R> local =
      localIllumination(scene, vertex, d, fetchLocalShading<R>(scene, vertex.material), state.key,
                        state.bounce);
  const Vec3<R> radiance = withLight(vertex, state.throughput, local);
  const Vec3<R> mirrored = reflect3(d, vertex.normal);
  const Vec3<R> reflectance = fetchReflectance<R>(scene, vertex.material).specular;
  return leave(scene, state, vertex, radiance, mirrored, reflectance);
}

TWINTRACE_KERNEL_END
