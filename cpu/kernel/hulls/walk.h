#pragma once

// Twins of shaders/hulls/walks/*.glsl: the walks through hulls, one ray at a time.

#include <array>
#include <concepts>

#include "common/hulls/hull_counts.h"
#include "cpu/kernel/hulls/hull_access.h"
#include "cpu/kernel/primitive.h"

TWINTRACE_KERNEL_BEGIN

inline constexpr int kHullStack = 160;
inline constexpr int kHullHeap = 64;

/// A walk of one ray: R is a number of one lane. `Volume::enter` is the twin of enterHull: the test of
/// the hulls at hand.
template <class R, class Volume, bool counting>
class HullWalk {
 public:
  HullWalk(const SceneView& scene, const Ray<R>& ray)
      : scene_(scene), ray_(ray), prepared_(prepareHulls(scene, ray)) {}

  const HullCounts& counts() const { return counts_; }

  Hit<R> visitFlat(const Hit<R>& start) {
    Hit<R> best = start;
    for (int node = 0; node < scene_.hulls.nodeCount; ++node) {
      if (enterCounted(node) <= best.t) best = visitLeaf(fetchHullLink(scene_, node), best);
    }
    return best;
  }

  Hit<R> visitTree(const Hit<R>& start) { return visitSubtree(0, enterCounted(0), start); }

  Hit<R> visitHeap(const Hit<R>& start) {
    Hit<R> best = start;
    Heap heap;
    const R atRoot = enterCounted(0);
    if (atRoot <= best.t) heap.push({0, atRoot});
    while (heap.size > 0) {
      const Waiting top = heap.pop();
      if (!(top.entry <= best.t)) break;  // so is everything below
      count(&HullCounts::nodes);
      const HullLink link = fetchHullLink(scene_, top.node);
      if (!link.inner) best = visitLeaf(link, best);
      for (int i = 0; link.inner && i < link.count; ++i) {
        const R entry = enterCounted(link.first + i);
        if (!(entry <= best.t)) continue;
        if (heap.size == kHullHeap) {
          count(&HullCounts::heapOverflows);
          best = visitSubtree(link.first + i, entry, best);
        } else {
          heap.push({link.first + i, entry});
          count(&HullCounts::heapPushes);
        }
      }
    }
    return best;
  }

 private:
  struct Waiting {
    int node;
    R entry;
  };

  /// The nearest on top. The twin does the same moves, so that equal entries come out in its order.
  struct Heap {
    std::array<Waiting, kHullHeap> waiting;
    int size = 0;

    void push(const Waiting& added) {
      int at = size++;
      for (; at > 0 && waiting[(at - 1) / 2].entry > added.entry; at = (at - 1) / 2) {
        waiting[at] = waiting[(at - 1) / 2];
      }
      waiting[at] = added;
    }

    Waiting pop() {
      const Waiting top = waiting[0];
      const Waiting sinking = waiting[--size];
      int place = 0;
      while (true) {
        int child = 2 * place + 1;
        if (child + 1 < size && waiting[child + 1].entry < waiting[child].entry) ++child;
        if (child >= size || !(waiting[child].entry < sinking.entry)) break;
        waiting[place] = waiting[child];
        place = child;
      }
      waiting[place] = sinking;
      return top;
    }
  };

  void count(int HullCounts::*counter, int by = 1) {
    if constexpr (counting) counts_.*counter += by;
  }

  R enterCounted(int node) {
    const R entry = Volume::enter(scene_, prepared_, node * scene_.hulls.nodeTexels);
    count(&HullCounts::hullTests);
    count(&HullCounts::hullHits, entry <= R(kLargest) ? 1 : 0);
    return entry;
  }

  Hit<R> visitLeaf(const HullLink& link, const Hit<R>& start) {
    Hit<R> best = start;
    bool any = false;
    for (int i = 0; i < link.count; ++i) {
      const int primitive = fetchReference(scene_, link.first + i);
      const R t = intersectPrimitive(scene_, ray_, primitive);
      any = any || t <= ray_.tmax;
      best = nearer(best, t, primitive);
    }
    count(&HullCounts::primitiveTests, link.count);
    count(&HullCounts::falseHullHits, any ? 0 : 1);
    return best;
  }

  Hit<R> visitSubtree(int root, R entry, const Hit<R>& start) {
    Hit<R> best = start;
    std::array<Waiting, kHullStack> stack;
    stack[0] = {root, entry};
    int size = 1;
    while (size > 0) {
      const Waiting top = stack[--size];
      if (!(top.entry <= best.t)) continue;
      count(&HullCounts::nodes);
      const HullLink link = fetchHullLink(scene_, top.node);
      if (!link.inner) {
        best = visitLeaf(link, best);
        continue;
      }
      const int bottom = size;
      for (int i = 0; i < link.count; ++i) {
        const R childEntry = enterCounted(link.first + i);
        if (!(childEntry <= best.t)) continue;
        int place = size++;
        for (; place > bottom && stack[place - 1].entry <= childEntry; --place) {
          stack[place] = stack[place - 1];
        }
        stack[place] = {link.first + i, childEntry};
      }
    }
    return best;
  }

  const SceneView& scene_;
  const Ray<R>& ray_;
  HullRay<R> prepared_;
  HullCounts counts_;
};

TWINTRACE_KERNEL_END
