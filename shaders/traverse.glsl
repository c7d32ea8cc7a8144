// Queries against the whole scene.
#pragma once

#include "hulls/chosen_walk.glsl"

// Smallest t within the ray's closed interval, ties to the lowest primitive.
Hit closestHit(Ray ray) {
  precise Hit nothing = Hit(ray.tmax, kNoPrimitive);
  precise Hit result = visitScene(ray, nothing);
  return result;
}

// Whether anything lies within the ray's interval.
bool occluded(Ray ray) {
  return closestHit(ray).primitive != kNoPrimitive;
}
