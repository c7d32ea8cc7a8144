// The hull of the strategy at work. The host puts a file for another volume in this one's place.
#pragma once

#include "hulls/volumes/aabb.glsl"

// Where the ray enters the hull whose record begins at a texel, or infinity.
float enterHull(HullRay ray, int record) {
  return enterAabb(ray, record);
}
