#pragma once

// Twin of shaders/vertex.glsl: a path's arrival at its next vertex, common to all integrators.

#include "cpu/kernel/environment.h"
#include "cpu/kernel/path_state.h"
#include "cpu/kernel/hit_surface.h"
#include "cpu/kernel/traverse.h"

TWINTRACE_KERNEL_BEGIN

/// Radiance has the light found at the vertex added. Where `scatters` holds the integrator decides
/// how the path goes on; elsewhere the members after it have no meaning.
template <class R>
struct Vertex {
  Vec3<R> radiance;
  MaskOf<R> scatters;
  IntOf<R> material;
  Vec3<R> position;
  Vec3<R> facing;  ///< the geometric normal, against the ray
  Vec3<R> normal;  ///< for shading, against the ray
  Vec3<R> origin;  ///< of rays that leave on the side of `facing`
};

template <class R>
Vertex<R> arrive(const SceneView& scene, const PathState<R>& state, const Frame& frame) {
  using Int = IntOf<R>;
  using Mask = MaskOf<R>;
  const Hit<R> hit = closestHit(scene, state.ray);
  const Vec3<R>& d = state.ray.direction;
  const Mask missed = hit.primitive == Int(kNoPrimitive);
  const Mask escaped = state.alive && missed;
  const Mask found = state.alive && !missed;
  Vec3<R> radiance = state.radiance;
  if (anyLane(escaped)) {
    const Vec3<R> lit = radiance + state.throughput * environment(scene, d);
    radiance = select(escaped, lit, radiance);
  }
  const PrimitiveInfo<R> info =
      fetchPrimitiveInfo<R>(scene, select(found, hit.primitive, Int(0)));
  if (scene.effectEmission) {
    const Vec3<R> lit = radiance + state.throughput * info.emission;
    radiance = select(found, lit, radiance);
  }
  Mask scatters = found && state.bounce < Int(frame.bounces);
  if (!scene.effectIndirect) {
    scatters = scatters && state.bounce < Int(1);
  }
  Vertex<R> result{radiance,  scatters,  info.material, Vec3<R>(),
                   Vec3<R>(), Vec3<R>(), Vec3<R>()};
  if (anyLane(scatters)) {
    const Surface<R> surface = surfaceAt(scene, state.ray, hit);
    result.position = surface.position;
    result.facing = facingNormal(surface.normal, d);
    result.normal = shadingNormal(scene, hit, result.position, result.facing, d);
    result.origin = leavingOrigin(surface, result.facing);
  }
  return result;
}

/// The path's radiance with `light` from the vertex added.
template <class R>
Vec3<R> withLight(const Vertex<R>& vertex, const Vec3<R>& throughput, const Vec3<R>& light) {
  const Vec3<R> lit = vertex.radiance + throughput * light;
  return select(vertex.scatters, lit, vertex.radiance);
}

/// Whether a direction leads below a surface that only its shading normal has above it.
template <class R>
MaskOf<R> leadsBelow(const SceneView& scene, const Vertex<R>& vertex, const Vec3<R>& direction) {
  if (!scene.effectSmooth) return MaskOf<R>(false);
  return !(dot3(direction, vertex.facing) > R(0.0f));
}

/// Whether no light comes from a direction within a distance.
template <class R>
MaskOf<R> isBlocked(const SceneView& scene, const Vertex<R>& vertex, const Vec3<R>& direction,
                    R distance) {
  const MaskOf<R> behind = occluded(scene, makeRay(vertex.origin, direction, R(0.0f), distance));
  return leadsBelow(scene, vertex, direction) || behind;
}

/// A path that ends at the vertex.
template <class R>
PathState<R> stop(const PathState<R>& state, const Vec3<R>& radiance) {
  return {state.key, state.ray, state.throughput, radiance, state.bounce, MaskOf<R>(false)};
}

/// The path's next ray, unless nothing of its throughput is left.
template <class R>
PathState<R> leave(const SceneView& scene, const PathState<R>& state, const Vertex<R>& vertex,
                   const Vec3<R>& radiance, const Vec3<R>& direction, const Vec3<R>& weight) {
  const Vec3<R> throughput = state.throughput * weight;
  const Ray<R> ray = makeRay(vertex.origin, direction, R(0.0f), R(kLargest));
  const MaskOf<R> alive =
      vertex.scatters && !isBlack(throughput) && !leadsBelow(scene, vertex, direction);
  return {state.key, ray, throughput, radiance, state.bounce + IntOf<R>(1), alive};
}

TWINTRACE_KERNEL_END
