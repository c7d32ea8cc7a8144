// Axis-aligned boxes: minimum; maximum.
#pragma once

#include "hulls/hull_access.glsl"

float enterAabb(HullRay ray, int record) {
  precise vec3 low = floats3(fetchHullTexel(record));
  precise vec3 high = floats3(fetchHullTexel(record + 1));
  precise Interval inside = withinSlabs(wholeRay(ray.ray), ray.axes, low, high);
  precise float result = entryOf(inside);
  return result;
}
