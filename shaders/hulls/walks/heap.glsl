// Trees of hulls in the order of their entries: a heap holds what is open, the nearest on top. Kay and
// Kajiya 1986, section 4. Changed: the heap is limited; what finds no room is walked at once with the
// stack of tree.glsl.
#pragma once

#include "hulls/walks/tree.glsl"

const int kHullHeap = 64;

// In the heap; of the top something.
int parentOf(int place) {
  return (place - 1) / 2;
}

Hit visitHeap(Ray ray, Hit start) {
  precise HullRay prepared = prepareHulls(ray);
  precise Hit best = start;
  int waiting[kHullHeap];
  float entries[kHullHeap];
  int size = 0;
  precise float atRoot = enterCounted(prepared, 0);
  if (atRoot <= best.t) {
    waiting[0] = 0;
    entries[0] = atRoot;
    size = 1;
  }
  while (size > 0) {
    int node = waiting[0];
    precise bool open = entries[0] <= best.t;
    // The last one sinks from the top.
    size = size - 1;
    precise float sinking = entries[size];
    int sinkingNode = waiting[size];
    int place = 0;
    precise bool sinks = true;
    while (sinks) {
      int child = 2 * place + 1;
      int second = child + 1;
      if (second < size && entries[second] < entries[child]) {
        child = second;
      }
      sinks = child < size && entries[child] < sinking;
      if (sinks) {
        entries[place] = entries[child];
        waiting[place] = waiting[child];
        place = child;
      }
    }
    entries[place] = sinking;
    waiting[place] = sinkingNode;
    if (!open) {
      size = 0;  // so is everything below
    } else {
      if (kHullCounting) {
        hullCounts.nodes += 1;
      }
      precise HullLink link = fetchHullLink(node);
      if (!link.inner) {
        best = visitLeaf(ray, link, best);
      }
      for (int i = 0; link.inner && i < link.count; ++i) {
        precise float entry = enterCounted(prepared, link.first + i);
        precise bool enters = entry <= best.t;
        if (enters && size == kHullHeap) {
          if (kHullCounting) {
            hullCounts.heapOverflows += 1;
          }
          best = visitSubtree(ray, prepared, link.first + i, entry, best);
        } else if (enters) {
          int at = size;
          int above = parentOf(at);
          while (at > 0 && entries[above] > entry) {
            entries[at] = entries[above];
            waiting[at] = waiting[above];
            at = above;
            above = parentOf(at);
          }
          entries[at] = entry;
          waiting[at] = link.first + i;
          size = size + 1;
          if (kHullCounting) {
            hullCounts.heapPushes += 1;
          }
        }
      }
    }
  }
  return best;
}
