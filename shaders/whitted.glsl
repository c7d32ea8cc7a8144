// Integrators `local` (Phong illumination, eq. 1) and `whitted` (eq. 2: local plus the mirror
// reflection). Whitted 1980, "An Improved Illumination Model for Shaded Display".
#pragma once

#include "light.glsl"
#include "vertex.glsl"

// Eq. 1 without k_e. Changed: the visibility g belongs to each light, not to the whole sum.
vec3 localIllumination(Vertex vertex, vec3 d, LocalShading material, SampleKey key, int bounce) {
  precise vec3 sum = material.ambient * fetchEnvironmentRadiance();
  for (int i = 0; i < kLightCount; ++i) {
    int dimension = kDimensionLight + i * kDimensionsPerLight;
    precise float u = noise(key, bounce, dimension);
    precise float v = noise(key, bounce, dimension + 1);
    precise LightSample light = sampleLight(fetchLight(i), vertex.origin, u, v);
    precise vec3 bisector = light.direction - d;
    precise vec3 halfway = normalize3(bisector);
    precise float lambert = greatest(dot3(vertex.normal, light.direction), 0.0f);
    precise float highlight = power(dot3(halfway, vertex.normal), material.exponent);
    precise vec3 diffuse = material.albedo * lambert;
    precise vec3 shaded = (diffuse + material.highlight * highlight) * light.value;
    precise bool faces = lambert > 0.0f;
    precise bool blocked = isBlocked(vertex, light.direction, light.distance);
    sum = sum + select(faces && !blocked, shaded, vec3(0.0f));
  }
  return sum;
}

PathState stepLocal(PathState state, Frame frame) {
  precise Vertex vertex = arrive(state, frame);
  precise vec3 radiance = vertex.radiance;
  if (anyLane(vertex.scatters)) {
    precise vec3 local =
        localIllumination(vertex, state.ray.direction, fetchLocalShading(vertex.material), state.key,
                          state.bounce);
    radiance = withLight(vertex, state.throughput, local);
  }
  return stop(state, radiance);
}

PathState stepWhitted(PathState state, Frame frame) {
  precise Vertex vertex = arrive(state, frame);
  if (!anyLane(vertex.scatters)) {
    return stop(state, vertex.radiance);
  }
  precise vec3 d = state.ray.direction;
  precise vec3 local =
      localIllumination(vertex, d, fetchLocalShading(vertex.material), state.key, state.bounce);
  precise vec3 radiance = withLight(vertex, state.throughput, local);
  precise vec3 mirrored = reflect3(d, vertex.normal);
  precise vec3 reflectance = fetchReflectance(vertex.material).specular;
  return leave(state, vertex, radiance, mirrored, reflectance);
}
