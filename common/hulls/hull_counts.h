#pragma once

#include <cstdint>

namespace twintrace {

/// What walks through hulls cost. Hull hits without any hit of the primitives within are false.
template <class Count>
struct HullCountsOf {
  Count hullTests = 0;
  Count hullHits = 0;
  Count falseHullHits = 0;
  Count primitiveTests = 0;
  Count nodes = 0;
  Count heapPushes = 0;
  Count heapOverflows = 0;

  template <class Other>
  HullCountsOf& operator+=(const HullCountsOf<Other>& other) {
    hullTests += other.hullTests;
    hullHits += other.hullHits;
    falseHullHits += other.falseHullHits;
    primitiveTests += other.primitiveTests;
    nodes += other.nodes;
    heapPushes += other.heapPushes;
    heapOverflows += other.heapOverflows;
    return *this;
  }
  friend HullCountsOf operator+(HullCountsOf a, const HullCountsOf& b) { return a += b; }
  friend bool operator==(const HullCountsOf&, const HullCountsOf&) = default;
};

using HullCounts = HullCountsOf<std::int32_t>;  ///< of one ray
using HullTotals = HullCountsOf<std::int64_t>;  ///< of all rays of a run

}  // namespace twintrace
