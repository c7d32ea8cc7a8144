// Integrator `path`: unbiased path tracing. Emission is found by hitting it; local lights, which
// can't be hit, are sampled at every vertex. Kajiya 1986, "The Rendering Equation".
#pragma once

#include "light.glsl"
#include "material.glsl"
#include "vertex.glsl"

// Light of all local lights reflected at a vertex along -d.
vec3 directLight(Vertex vertex, vec3 d, Reflectance material, SampleKey key, int bounce) {
  precise vec3 sum = vec3(0.0f);
  for (int i = 0; i < kLightCount; ++i) {
    int dimension = kDimensionLight + i * kDimensionsPerLight;
    precise float u = noise(key, bounce, dimension);
    precise float v = noise(key, bounce, dimension + 1);
    precise LightSample light = sampleLight(fetchLight(i), vertex.origin, u, v);
    precise vec3 reflected =
        evaluateReflectance(material, vertex.normal, d, light.direction) * light.value;
    precise bool blocked = isBlocked(vertex, light.direction, light.distance);
    sum = sum + select(blocked, vec3(0.0f), reflected);
  }
  return sum;
}

// One vertex: the light found there, and the next ray.
PathState stepPath(PathState state, Frame frame) {
  precise Vertex vertex = arrive(state, frame);
  precise vec3 radiance = vertex.radiance;
  if (!anyLane(vertex.scatters)) {
    return stop(state, radiance);
  }
  precise vec3 d = state.ray.direction;
  if (kEffectPointLight || kEffectSphereLight || kEffectSunLight) {
    precise vec3 direct =
        directLight(vertex, d, fetchReflectance(vertex.material), state.key, state.bounce);
    radiance = withLight(vertex, state.throughput, direct);
  }
  precise ScatterSample next = sampleScattering(
      fetchScattering(vertex.material), vertex.normal, d,
      noise(state.key, state.bounce, kDimensionLobe),
      noise(state.key, state.bounce, kDimensionDirectionU),
      noise(state.key, state.bounce, kDimensionDirectionV));
  return leave(state, vertex, radiance, next.direction, next.weight);
}
