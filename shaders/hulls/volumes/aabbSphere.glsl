// A box and a sphere, tested one after the other: minimum; maximum; center and radius.
#pragma once

#include "hulls/volumes/aabb.glsl"
#include "hulls/volumes/sphere.glsl"

float enterAabbSphere(HullRay ray, int record) {
  precise float result = enterAabb(ray, record);
  if (result <= kLargest) {
    precise float entry = enterSphere(ray, record + 2);
    result = greatest(result, entry);
  }
  return result;
}
