// What one invocation's walk through hulls costs, in the instrumented variant.
#pragma once

// Hull hits without any hit of the primitives within are false.
struct HullCounts {
  int hullTests;
  int hullHits;
  int falseHullHits;
  int primitiveTests;
  int nodes;
  int heapPushes;
  int heapOverflows;
};

HullCounts hullCounts = HullCounts(0, 0, 0, 0, 0, 0, 0);
