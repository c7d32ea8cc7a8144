// Trees of hulls, walked depth first from near to far with a stack of the entries still open.
#pragma once

#include "hulls/walks/leaf.glsl"

// Nodes that may wait: the children of each level but one. common/hulls/topology.h bounds the depth.
const int kHullStack = 160;

// The better of the best hit and those below a node that the ray enters at `entry`.
Hit visitSubtree(Ray ray, HullRay prepared, int root, float entry, Hit start) {
  precise Hit best = start;
  int waiting[kHullStack];
  float entries[kHullStack];
  waiting[0] = root;
  entries[0] = entry;
  int size = 1;
  while (size > 0) {
    size = size - 1;
    precise bool open = entries[size] <= best.t;
    if (open) {
      if (kHullCounting) {
        hullCounts.nodes += 1;
      }
      precise HullLink link = fetchHullLink(waiting[size]);
      if (!link.inner) {
        best = visitLeaf(ray, link, best);
      } else {
        int bottom = size;
        for (int i = 0; i < link.count; ++i) {
          precise float childEntry = enterCounted(prepared, link.first + i);
          precise bool enters = childEntry <= best.t;
          if (enters) {
            // The nearest on top; of equal ones the first.
            int place = size;
            int below = size - 1;
            while (place > bottom && entries[below] <= childEntry) {
              entries[place] = entries[below];
              waiting[place] = waiting[below];
              place = below;
              below = place - 1;
            }
            entries[place] = childEntry;
            waiting[place] = link.first + i;
            size = size + 1;
          }
        }
      }
    }
  }
  return best;
}

Hit visitTree(Ray ray, Hit start) {
  precise HullRay prepared = prepareHulls(ray);
  precise Hit result = visitSubtree(ray, prepared, 0, enterCounted(prepared, 0), start);
  return result;
}
