// One hull for each object, without any order among them.
#pragma once

#include "hulls/walks/leaf.glsl"

Hit visitFlat(Ray ray, Hit start) {
  precise HullRay prepared = prepareHulls(ray);
  precise Hit best = start;
  for (int node = 0; node < kHullNodeCount; ++node) {
    precise float entry = enterCounted(prepared, node);
    precise bool enters = entry <= best.t;
    if (enters) {
      best = visitLeaf(ray, fetchHullLink(node), best);
    }
  }
  return best;
}
