#pragma once

// Twin of shaders/report.glsl: eq. 12 with the report's estimator as it is, faults included.

#include "cpu/kernel/light.h"
#include "cpu/kernel/vertex.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
struct RandomPair {
  R first;   ///< roulette and polar angle
  R second;  ///< azimuth
};

/// rand(co) and rand(co.yx) with co from the hit point, the frame and the depth; with pcg the same
/// two decisions draw from counters.
template <class R>
RandomPair<R> reportRandom(const SceneView& scene, const SampleKey<R>& key, const Vec3<R>& p,
                           IntOf<R> bounce) {
  using N = NoiseOf<R>;
  if (scene.noiseSine) {
    const N px = narrowed<R>(p.x);
    const N py = narrowed<R>(p.y);
    const N pz = narrowed<R>(p.z);
    const N x = (pz + py) + unitFloat<N>(key.frame) * N(16.0f);
    const N y = (px + py) + toNumber<N>(bounce);
    return {widened<R>(sineHash(x, y)), widened<R>(sineHash(y, x))};
  }
  return {noise<R>(scene, key, bounce, kDimensionDirectionU),
          noise<R>(scene, key, bounce, kDimensionDirectionV)};
}

/// Lambert's term of eq. 1 for every local light, towards one point of its first octant.
template <class R>
Vec3<R> reportDirectLight(const SceneView& scene, const Vertex<R>& vertex, const Vec3<R>& albedo,
                          const SampleKey<R>& key, IntOf<R> bounce) {
  Vec3<R> sum;
  for (int i = 0; i < scene.index.lightCount; ++i) {
    const Light<R> light = fetchLight<R>(scene, i);
    const int dimension = kDimensionLight + i * kDimensionsPerLight;
    const Vec3<R> corner(noise<R>(scene, key, bounce, dimension),
                         noise<R>(scene, key, bounce, dimension + 1),
                         noise<R>(scene, key, bounce, dimension + 2));
    const Vec3<R> octant = normalize3(corner) * light.radius;
    const bool sphere = light.kind == kLightSphere;
    const bool sun = light.kind == kLightSun;
    const Vec3<R> towards = (sphere ? light.position + octant : light.position) - vertex.origin;
    const R squared = dot3(towards, towards);
    const R distance = squareRoot(squared);
    const R area = constant<R>(kPi) * (light.radius * light.radius);
    const Vec3<R> intensity = sphere ? light.radiance * area : light.radiance;
    const Vec3<R> direction = sun ? light.position : divide(towards, distance);
    const Vec3<R> value = sun ? light.radiance : divide(intensity, squared);
    const R reach = sun ? R(kLargest) : shadowReach(distance);
    const R cosine = greatest(dot3(vertex.normal, direction), R(0.0f));
    const MaskOf<R> blocked = isBlocked(scene, vertex, direction, reach);
    const Vec3<R> reflected = albedo * (value * cosine);
    sum = sum + select(blocked, Vec3<R>(), reflected);
  }
  return sum;
}

template <class R>
PathState<R> stepReport(const SceneView& scene, const PathState<R>& state, const Frame& frame) {
  using Mask = MaskOf<R>;
  const Vertex<R> vertex = arrive(scene, state, frame);
  Vec3<R> radiance = vertex.radiance;
  if (!anyLane(vertex.scatters)) return stop(state, radiance);
  const Vec3<R>& normal = vertex.normal;
  const Scattering<R> chances = fetchScattering<R>(scene, vertex.material);
  const Reflectance<R> colours = fetchReflectance<R>(scene, vertex.material);
  if (scene.effectAnyLight()) {
    const Vec3<R> direct = reportDirectLight(scene, vertex, colours.albedo, state.key,
                                             state.bounce);
    radiance = withLight(vertex, state.throughput, direct);
  }
  const RandomPair<R> random = reportRandom<R>(scene, state.key, vertex.position, state.bounce);
  const Mask specular = random.first < chances.specularChance;
  const Mask mirror = specular && chances.lobe == IntOf<R>(kLobeMirror);
  const Vec3<R> mirrored = reflect3(state.ray.direction, normal);
  const Vec3<R> axis = select(specular, mirrored, normal);
  const R inverse = select(specular, chances.phongInverse, R(0.5f));
  const Vec3<R> local = samplePowerHemisphere(inverse, random.first, random.second);
  const Vec3<R> direction = select(mirror, mirrored, tangentToWorld(axis, local));
  const R cosine = dot3(normal, direction);
  const R raised = select(specular, cosine * chances.phongScale, cosine);
  const R factor = clampTo(raised, R(0.0f), R(1.0f));
  const Vec3<R> weight = select(specular, colours.specular, colours.albedo) * factor;
  return leave(scene, state, vertex, radiance, direction, weight);
}

TWINTRACE_KERNEL_END
