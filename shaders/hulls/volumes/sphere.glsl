// Spheres: center, radius.
#pragma once

#include "hulls/hull_access.glsl"

float enterSphere(HullRay ray, int record) {
  uvec4 ball = fetchHullTexel(record);
  precise vec3 d = ray.ray.direction;
  precise vec3 f = ray.ray.origin - floats3(ball);
  precise float inverse = divide(1.0f, dot3(d, d));
  precise float t = -dot3(f, d) * inverse;
  precise vec3 nearest = f + d * t;
  // The nearest point is off by less than the slack.
  precise float radius = float4th(ball) + 2.0f * ray.slack;
  precise float halfChordSquared = (radius * radius - dot3(nearest, nearest)) * inverse;
  precise float halfChord = squareRoot(halfChordSquared);
  precise float near = t - halfChord;
  precise float entry = greatest(ray.ray.tmin, near);
  precise Interval inside = Interval(entry, t + halfChord);
  precise float result = select(halfChordSquared < 0.0f, kInfinity, entryOf(inside));
  return result;
}
