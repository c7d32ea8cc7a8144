// What all traversals do at hulls and at primitives, counted in the instrumented variant.
#pragma once

#include "hulls/chosen_hull.glsl"
#include "hulls/walks/hull_counts.glsl"
#include "primitive.glsl"

// Where the ray enters a node's hull, a lower bound of every t found inside; infinity if it does not.
float enterCounted(HullRay ray, int node) {
  precise float entry = enterHull(ray, node * kHullNodeTexels);
  if (kHullCounting) {
    hullCounts.hullTests += 1;
    hullCounts.hullHits += select(entry <= kLargest, 1, 0);
  }
  return entry;
}

// The better of the best hit and those of a leaf's primitives.
Hit visitLeaf(Ray ray, HullLink link, Hit start) {
  precise Hit best = start;
  precise bool any = false;
  for (int i = 0; i < link.count; ++i) {
    int primitive = fetchReference(link.first + i);
    precise float t = intersectPrimitive(ray, primitive);
    any = any || t <= ray.tmax;
    best = nearer(best, t, primitive);
  }
  if (kHullCounting) {
    hullCounts.primitiveTests += link.count;
    hullCounts.falseHullHits += select(any, 0, 1);
  }
  return best;
}
