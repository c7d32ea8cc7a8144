// One primitive of the texel array, of whatever kind.
#pragma once

#include "intersect.glsl"
#include "scene_access.glsl"

// The distance to a primitive that has bounds, or infinity. The kinds' distances meet in one precise
// local: returned from each branch, Mesa 22.3 rewrites the arithmetic behind them.
float intersectPrimitive(Ray ray, int primitive) {
  precise float result = kInfinity;
  int box = primitive - kSphereCount;
  int orientedBox = box - kBoxCount;
  int triangle = orientedBox - kOrientedBoxCount;
  if (kEffectSphere && box < 0) {
    result = intersectSphere(ray, fetchSphere(primitive));
  } else if (kEffectBox && box >= 0 && orientedBox < 0) {
    result = intersectBox(ray, fetchBox(box));
  } else if (kEffectOrientedBox && orientedBox >= 0 && triangle < 0) {
    result = intersectOrientedBox(ray, fetchOrientedBox(orientedBox));
  } else if (kEffectTriangle && triangle >= 0) {
    result = intersectTriangle(ray, fetchTriangle(triangle));
  }
  return result;
}
