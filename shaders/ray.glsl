// Rays, hits and the total order among hits.
#pragma once

#include "math.glsl"

// A ray with a closed interval. `inverse` is 1 / direction, with +infinity for a zero component of
// either sign, as the slab test needs it.
struct Ray {
  vec3 origin;
  vec3 direction;
  vec3 inverse;
  float tmin;
  float tmax;
};

// Closest hit so far; primitive is kNoPrimitive for a miss.
struct Hit {
  float t;
  int primitive;
};

float inverseOrInfinity(float x) {
  precise float result = select(x == 0.0f, kInfinity, divide(1.0f, x));
  return result;
}

Ray makeRay(vec3 origin, vec3 direction, float tmin, float tmax) {
  precise vec3 inverse = vec3(inverseOrInfinity(direction.x), inverseOrInfinity(direction.y),
                              inverseOrInfinity(direction.z));
  precise Ray result = Ray(origin, direction, inverse, tmin, tmax);
  return result;
}

vec3 pointAt(Ray ray, float t) {
  precise vec3 result = ray.origin + ray.direction * t;
  return result;
}

// The better of the best hit and a candidate: smaller t, then lower primitive. A candidate that
// misses has t = infinity, which no best hit has.
Hit nearer(Hit best, float t, int primitive) {
  precise bool closer = t < best.t || (t == best.t && primitive < best.primitive);
  precise float bestT = select(closer, t, best.t);
  precise Hit result = Hit(bestT, select(closer, primitive, best.primitive));
  return result;
}
