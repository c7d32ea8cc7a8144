// Integrator `report`: eq. 12 with the report's estimator as it is. Its faults are kept on purpose:
// the cosine counts twice on diffuse bounces, one random number serves both the roulette and the
// polar angle, no lobe is divided by its chance, light points come from one octant of the sphere.
#pragma once

#include "light.glsl"
#include "vertex.glsl"

struct RandomPair {
  float first;   // roulette and polar angle
  float second;  // azimuth
};

// rand(co) and rand(co.yx) with co from the hit point, the frame and the depth, as the report seeds
// its sine hash; with pcg the same two decisions draw from counters.
RandomPair reportRandom(SampleKey key, vec3 p, int bounce) {
  if (kNoiseSine) {
    precise float x = (p.z + p.y) + unitFloat(key.frame) * 16.0f;
    precise float y = (p.x + p.y) + float(bounce);
    precise RandomPair swapped = RandomPair(sineHash(x, y), sineHash(y, x));
    return swapped;
  }
  precise RandomPair counted = RandomPair(noise(key, bounce, kDimensionDirectionU),
                                          noise(key, bounce, kDimensionDirectionV));
  return counted;
}

// Lambert's term of eq. 1 for every local light, towards one point of its first octant.
vec3 reportDirectLight(Vertex vertex, vec3 albedo, SampleKey key, int bounce) {
  precise vec3 sum = vec3(0.0f);
  for (int i = 0; i < kLightCount; ++i) {
    precise Light light = fetchLight(i);
    int dimension = kDimensionLight + i * kDimensionsPerLight;
    precise vec3 corner =
        vec3(noise(key, bounce, dimension), noise(key, bounce, dimension + 1),
             noise(key, bounce, dimension + 2));
    precise vec3 octant = normalize3(corner) * light.radius;
    precise bool sphere = light.kind == kLightSphere;
    precise bool sun = light.kind == kLightSun;
    precise vec3 point = light.position + octant;
    precise vec3 towards = select(sphere, point, light.position) - vertex.origin;
    precise float squared = dot3(towards, towards);
    precise float distance = squareRoot(squared);
    precise float area = kPi * (light.radius * light.radius);
    precise vec3 whole = light.radiance * area;
    precise vec3 intensity = select(sphere, whole, light.radiance);
    precise vec3 direction = select(sun, light.position, divide(towards, distance));
    precise vec3 value = select(sun, light.radiance, divide(intensity, squared));
    precise float reach = select(sun, kLargest, shadowReach(distance));
    precise float cosine = greatest(dot3(vertex.normal, direction), 0.0f);
    precise bool blocked = isBlocked(vertex, direction, reach);
    precise vec3 reflected = albedo * (value * cosine);
    sum = sum + select(blocked, vec3(0.0f), reflected);
  }
  return sum;
}

PathState stepReport(PathState state, Frame frame) {
  precise Vertex vertex = arrive(state, frame);
  precise vec3 radiance = vertex.radiance;
  if (!anyLane(vertex.scatters)) {
    return stop(state, radiance);
  }
  precise vec3 normal = vertex.normal;
  precise Scattering chances = fetchScattering(vertex.material);
  precise Reflectance colours = fetchReflectance(vertex.material);
  if (kEffectPointLight || kEffectSphereLight || kEffectSunLight) {
    precise vec3 direct =
        reportDirectLight(vertex, colours.albedo, state.key, state.bounce);
    radiance = withLight(vertex, state.throughput, direct);
  }
  precise RandomPair random = reportRandom(state.key, vertex.position, state.bounce);
  precise bool specular = random.first < chances.specularChance;
  precise bool mirror = specular && chances.lobe == kLobeMirror;
  precise vec3 mirrored = reflect3(state.ray.direction, normal);
  precise vec3 axis = select(specular, mirrored, normal);
  precise float inverse = select(specular, chances.phongInverse, 0.5f);
  precise vec3 local = samplePowerHemisphere(inverse, random.first, random.second);
  precise vec3 direction = select(mirror, mirrored, tangentToWorld(axis, local));
  precise float cosine = dot3(normal, direction);
  precise float scaled = cosine * chances.phongScale;
  precise float raised = select(specular, scaled, cosine);
  precise float factor = clampTo(raised, 0.0f, 1.0f);
  precise vec3 weight = select(specular, colours.specular, colours.albedo) * factor;
  return leave(state, vertex, radiance, direction, weight);
}
