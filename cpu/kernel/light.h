#pragma once

// Twin of shaders/light.glsl: local lights, which light a surface only by being sampled.

#include "cpu/kernel/sampling.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

/// A direction towards a light; value is radiance over density, so that the light adds
/// bsdf * cos * value. Nothing nearer than `distance` may stand in between.
template <class R>
struct LightSample {
  Vec3<R> direction;
  R distance;
  Vec3<R> value;
};

template <class R>
LightSample<R> samplePointLight(const Light<R>& light, const Vec3<R>& position) {
  const Vec3<R> towards = light.position - position;
  const R squared = dot3(towards, towards);
  const R distance = squareRoot(squared);
  return {divide(towards, distance), distance, divide(light.radiance, squared)};
}

/// Uniform over the cone that the sphere fills. Shirley, Wang and Zimmerman 1996. Changed: 1 - cos of
/// the rim is sin^2 / (1 + cos), which does not cancel for far lights.
template <class R>
LightSample<R> sampleSphereLight(const Light<R>& light, const Vec3<R>& position, R u, R v) {
  const Vec3<R> towards = light.position - position;
  const R squared = dot3(towards, towards);
  const R centerDistance = squareRoot(squared);
  const R r2 = light.radius * light.radius;
  const R sinSquared = least(divide(r2, squared), R(1.0f));
  const R height = divide(sinSquared, R(1.0f) + squareRoot(R(1.0f) - sinSquared));
  const Vec3<R> local = sampleCone(height, u, v);
  const Vec3<R> direction = tangentToWorld(divide(towards, centerDistance), local);
  const R along = centerDistance * local.z;
  const R aside = squared * greatest(R(1.0f) - local.z * local.z, R(0.0f));
  const R distance = along - squareRoot(greatest(r2 - aside, R(0.0f)));
  return {direction, distance, light.radiance * (R(kTwoPi) * height)};
}

/// Uniform over the sun's disk; `radiance` already holds radiance times solid angle.
template <class R>
LightSample<R> sampleSunLight(const Light<R>& light, R u, R v) {
  const Vec3<R> direction = tangentToWorld(light.position, sampleCone(light.height, u, v));
  return {direction, R(kLargest), light.radiance};
}

template <class R>
LightSample<R> chosenLightSample(bool condition, const LightSample<R>& a,
                                 const LightSample<R>& b) {
  return condition ? a : b;
}

template <class R>
LightSample<R> sampleLight(const SceneView& scene, const Light<R>& light, const Vec3<R>& position,
                           R u, R v) {
  LightSample<R> result{Vec3<R>(R(0.0f), R(1.0f), R(0.0f)), R(kLargest), Vec3<R>()};
  if (scene.effectPointLight && light.kind == kLightPoint) {
    result = chosenLightSample(true, samplePointLight(light, position), result);
  }
  if (scene.effectSphereLight && light.kind == kLightSphere) {
    result = chosenLightSample(true, sampleSphereLight(light, position, u, v), result);
  }
  if (scene.effectSunLight && light.kind == kLightSun) {
    result = chosenLightSample(true, sampleSunLight(light, u, v), result);
  }
  return result;
}

TWINTRACE_KERNEL_END
