// Discrete oriented polytopes: the slabs of kHullGroups groups of three normals, minimum and maximum of
// each group. Kay and Kajiya 1986; Klosowski et al. 1998.
#pragma once

#include "hulls/hull_access.glsl"

Interval withinGroup(Interval given, SlabGroup group, int record) {
  precise Interval result =
      withinSlabs(given, group, floats3(fetchHullTexel(record)), floats3(fetchHullTexel(record + 1)));
  return result;
}

float enterKdop(HullRay ray, int record) {
  precise Interval inside = withinGroup(wholeRay(ray.ray), ray.axes, record);
  if (kHullGroups > 1) {
    inside = withinGroup(inside, ray.second, record + 2);
  }
  if (kHullGroups > 2) {
    inside = withinGroup(inside, ray.third, record + 4);
  }
  if (kHullGroups > 3) {
    inside = withinGroup(inside, ray.fourth, record + 6);
  }
  if (kHullGroups > 4) {
    inside = withinGroup(inside, ray.fifth, record + 8);
  }
  precise float result = entryOf(inside);
  return result;
}
