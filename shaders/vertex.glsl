// A path's arrival at its next vertex, common to all integrators.
#pragma once

#include "environment.glsl"
#include "path_state.glsl"
#include "surface.glsl"
#include "traverse.glsl"

// State has the light found at the vertex added and is no longer alive; where `scatters` holds the
// integrator decides how the path goes on. Elsewhere the other members have no meaning.
struct Vertex {
  PathState state;
  bool scatters;
  int material;
  vec3 position;
  vec3 normal;  // faces against the ray
  vec3 origin;  // of rays that leave along the normal's side
};

Vertex arrive(PathState state, Frame frame) {
  precise Hit hit = closestHit(state.ray);
  precise vec3 d = state.ray.direction;
  bool missed = hit.primitive == kNoPrimitive;
  bool escaped = state.alive && missed;
  bool found = state.alive && !missed;
  precise vec3 radiance = state.radiance;
  if (anyLane(escaped)) {
    precise vec3 lit = radiance + state.throughput * environment(d);
    radiance = select(escaped, lit, radiance);
  }
  int material = fetchMaterialIndex(select(found, hit.primitive, 0));
  if (kEffectEmission) {
    precise vec3 lit = radiance + state.throughput * fetchEmission(material);
    radiance = select(found, lit, radiance);
  }
  bool scatters = found && state.bounce < frame.bounces;
  if (!kEffectIndirect) {
    scatters = scatters && state.bounce < 1;
  }
  precise PathState arrived = state;
  arrived.radiance = radiance;
  arrived.alive = false;
  precise vec3 none = vec3(0.0f);
  precise Vertex result = Vertex(arrived, scatters, material, none, none, none);
  if (anyLane(scatters)) {
    precise Surface surface = surfaceAt(state.ray, hit);
    result.position = surface.position;
    result.normal = facingNormal(surface.normal, d);
    result.origin = leavingOrigin(surface, result.normal);
  }
  return result;
}

PathState withLight(Vertex vertex, vec3 light) {
  precise vec3 lit = vertex.state.radiance + vertex.state.throughput * light;
  precise PathState result = vertex.state;
  result.radiance = select(vertex.scatters, lit, vertex.state.radiance);
  return result;
}

// The path's next ray, unless nothing of its throughput is left.
PathState leave(Vertex vertex, PathState state, vec3 direction, vec3 weight) {
  precise vec3 throughput = state.throughput * weight;
  precise PathState result = state;
  result.throughput = throughput;
  result.ray = makeRay(vertex.origin, direction, 0.0f, kLargest);
  result.bounce = state.bounce + 1;
  result.alive = vertex.scatters && !isBlack(throughput);
  return result;
}
