// Local lights: points, spheres and suns. They are invisible to rays and light a surface only by
// being sampled.
#pragma once

#include "sampling.glsl"
#include "scene_access.glsl"

// Shadow rays end 16 units of 2^-24 short of the light: what lies at the light itself, such as the
// ceiling that a lamp touches, is computed at the light's distance within a few roundings, and does
// not stand in between.
const float kShadowGap = 9.5e-7f;

// How far a shadow ray goes to something at that distance.
float shadowReach(float distance) {
  precise float shortened = distance * (1.0f - kShadowGap);
  precise float result = least(shortened, kLargest);
  return result;
}

// A direction towards a light; value is radiance over density, so that the light adds
// bsdf * cos * value. Nothing within `distance` may stand in between.
struct LightSample {
  vec3 direction;
  float distance;
  vec3 value;
};

LightSample samplePointLight(Light light, vec3 position) {
  precise vec3 towards = light.position - position;
  precise float squared = dot3(towards, towards);
  precise float distance = squareRoot(squared);
  precise vec3 direction = divide(towards, distance);
  precise LightSample result = LightSample(direction, shadowReach(distance), divide(light.radiance, squared));
  return result;
}

// Uniform over the cone that the sphere fills, all directions for a point inside. Shirley, Wang and
// Zimmerman 1996, "Monte Carlo Techniques for Direct Lighting Calculations". Changed: 1 - cos of the
// rim is sin^2 / (1 + cos), which does not cancel for far lights.
LightSample sampleSphereLight(Light light, vec3 position, float u, float v) {
  precise vec3 towards = light.position - position;
  precise float squared = dot3(towards, towards);
  precise float centerDistance = squareRoot(squared);
  precise float r2 = light.radius * light.radius;
  precise bool inside = squared <= r2;
  precise float sinSquared = least(divide(r2, squared), 1.0f);
  precise float cosSquared = 1.0f - sinSquared;
  precise float rimCosine = squareRoot(cosSquared);
  precise float onePlusCosine = 1.0f + rimCosine;
  precise float rim = divide(sinSquared, onePlusCosine);
  precise float height = select(inside, 2.0f, rim);
  precise bool central = centerDistance > 0.0f;
  precise vec3 axis = select(central, divide(towards, centerDistance), vec3(0.0f, 1.0f, 0.0f));
  precise vec3 local = sampleCone(height, u, v);
  precise vec3 direction = tangentToWorld(axis, local);
  precise float along = centerDistance * local.z;
  precise float localSquared = 1.0f - local.z * local.z;
  precise float aside = squared * greatest(localSquared, 0.0f);
  precise float chordSquared = r2 - aside;
  precise float chord = squareRoot(greatest(chordSquared, 0.0f));
  precise float farther = along + chord;
  precise float closer = along - chord;
  precise float distance = select(inside, farther, closer);
  precise vec3 value = light.radiance * (kTwoPi * height);
  precise LightSample result = LightSample(direction, shadowReach(distance), value);
  return result;
}

// Uniform over the sun's disk; `radiance` already holds radiance times solid angle.
LightSample sampleSunLight(Light light, float u, float v) {
  precise vec3 direction = tangentToWorld(light.position, sampleCone(light.height, u, v));
  precise LightSample result = LightSample(direction, kLargest, light.radiance);
  return result;
}

LightSample chosenLightSample(bool condition, LightSample a, LightSample b) {
  precise vec3 direction = select(condition, a.direction, b.direction);
  precise float distance = select(condition, a.distance, b.distance);
  precise vec3 value = select(condition, a.value, b.value);
  precise LightSample result = LightSample(direction, distance, value);
  return result;
}

LightSample sampleLight(Light light, vec3 position, float u, float v) {
  precise LightSample result = LightSample(vec3(0.0f, 1.0f, 0.0f), kLargest, vec3(0.0f));
  if (kEffectPointLight) {
    precise LightSample point = samplePointLight(light, position);
    result = chosenLightSample(light.kind == kLightPoint, point, result);
  }
  if (kEffectSphereLight) {
    precise LightSample sphere = sampleSphereLight(light, position, u, v);
    result = chosenLightSample(light.kind == kLightSphere, sphere, result);
  }
  if (kEffectSunLight) {
    precise LightSample sun = sampleSunLight(light, u, v);
    result = chosenLightSample(light.kind == kLightSun, sun, result);
  }
  return result;
}
