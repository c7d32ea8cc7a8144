#pragma once

// Twin of shaders/light.glsl: local lights, which light a surface only by being sampled.

#include "cpu/kernel/sampling.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

/// Shadow rays end 16 units of 2^-24 short of the light; see shaders/light.glsl.
inline constexpr float kShadowGap = 9.5e-7f;

/// How far a shadow ray goes to something at that distance.
template <class R>
R shadowReach(R distance) {
  return least(distance * (R(1.0f) - errorBound<R>(kShadowGap)), R(kLargest));
}

/// A direction towards a light; value is radiance over density, so that the light adds
/// bsdf * cos * value. Nothing within `distance` may stand in between.
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
  return {divide(towards, distance), shadowReach(distance), divide(light.radiance, squared)};
}

/// Uniform over the cone that the sphere fills, all directions for a point inside. Shirley, Wang and
/// Zimmerman 1996. Changed: 1 - cos of the rim is sin^2 / (1 + cos), which does not cancel for far
/// lights.
template <class R>
LightSample<R> sampleSphereLight(const Light<R>& light, const Vec3<R>& position, R u, R v) {
  const Vec3<R> towards = light.position - position;
  const R squared = dot3(towards, towards);
  const R centerDistance = squareRoot(squared);
  const R r2 = light.radius * light.radius;
  const MaskOf<R> inside = squared <= r2;
  const R sinSquared = least(divide(r2, squared), R(1.0f));
  const R rimCosine = squareRoot(R(1.0f) - sinSquared);
  const R rim = divide(sinSquared, R(1.0f) + rimCosine);
  const R height = select(inside, R(2.0f), rim);
  const MaskOf<R> central = centerDistance > R(0.0f);
  const Vec3<R> axis = select(central, divide(towards, centerDistance),
                              Vec3<R>(R(0.0f), R(1.0f), R(0.0f)));
  const Vec3<R> local = sampleCone(height, u, v);
  const Vec3<R> direction = tangentToWorld(axis, local);
  const R along = centerDistance * local.z;
  const R aside = squared * greatest(R(1.0f) - local.z * local.z, R(0.0f));
  const R chord = squareRoot(greatest(r2 - aside, R(0.0f)));
  const R distance = select(inside, along + chord, along - chord);
  const Vec3<R> value = light.radiance * (constant<R>(kTwoPi) * height);
  return {direction, shadowReach(distance), value};
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
