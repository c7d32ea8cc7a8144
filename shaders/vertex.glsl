// A path's arrival at its next vertex, common to all integrators.
#pragma once

#include "environment.glsl"
#include "path_state.glsl"
#include "hit_surface.glsl"
#include "traverse.glsl"

// Radiance has the light found at the vertex added. Where `scatters` holds the integrator decides
// how the path goes on; elsewhere the members after it have no meaning.
struct Vertex {
  vec3 radiance;
  bool scatters;
  int material;
  vec3 position;
  vec3 facing;  // the geometric normal, against the ray
  vec3 normal;  // for shading, against the ray
  vec3 origin;  // of rays that leave on the side of `facing`
};

Vertex arrive(PathState state, Frame frame) {
  precise Hit hit = closestHit(state.ray);
  precise vec3 d = state.ray.direction;
  precise bool missed = hit.primitive == kNoPrimitive;
  precise bool escaped = state.alive && missed;
  precise bool found = state.alive && !missed;
  precise vec3 radiance = state.radiance;
  if (anyLane(escaped)) {
    precise vec3 lit = radiance + state.throughput * environment(d);
    radiance = select(escaped, lit, radiance);
  }
  precise PrimitiveInfo info = fetchPrimitiveInfo(select(found, hit.primitive, 0));
  if (kEffectEmission) {
    precise vec3 lit = radiance + state.throughput * info.emission;
    radiance = select(found, lit, radiance);
  }
  precise bool scatters = found && state.bounce < frame.bounces;
  if (!kEffectIndirect) {
    scatters = scatters && state.bounce < 1;
  }
  precise vec3 none = vec3(0.0f);
  precise Vertex result = Vertex(radiance, scatters, info.material, none, none, none, none);
  if (anyLane(scatters)) {
    precise Surface surface = surfaceAt(state.ray, hit);
    result.position = surface.position;
    result.facing = facingNormal(surface.normal, d);
    result.normal = shadingNormal(hit, result.position, result.facing, d);
    result.origin = leavingOrigin(surface, result.facing);
  }
  return result;
}

// The path's radiance with `light` from the vertex added.
vec3 withLight(Vertex vertex, vec3 throughput, vec3 light) {
  precise vec3 lit = vertex.radiance + throughput * light;
  precise vec3 result = select(vertex.scatters, lit, vertex.radiance);
  return result;
}

// Whether a direction leads below a surface that only its shading normal has above it.
bool leadsBelow(Vertex vertex, vec3 direction) {
  return kEffectSmooth && !(dot3(direction, vertex.facing) > 0.0f);
}

// Whether no light comes from a direction within a distance.
bool isBlocked(Vertex vertex, vec3 direction, float distance) {
  return leadsBelow(vertex, direction) ||
         occluded(makeRay(vertex.origin, direction, 0.0f, distance));
}

// A path that ends at the vertex.
PathState stop(PathState state, vec3 radiance) {
  precise PathState result =
      PathState(state.key, state.ray, state.throughput, radiance, state.bounce, false);
  return result;
}

// The path's next ray, unless nothing of its throughput is left.
PathState leave(PathState state, Vertex vertex, vec3 radiance, vec3 direction, vec3 weight) {
  precise vec3 throughput = state.throughput * weight;
  precise Ray ray = makeRay(vertex.origin, direction, 0.0f, kLargest);
  precise bool alive = vertex.scatters && !isBlack(throughput) && !leadsBelow(vertex, direction);
  precise PathState result =
      PathState(state.key, ray, throughput, radiance, state.bounce + 1, alive);
  return result;
}
