#pragma once

#include <cstdint>

namespace twintrace {

/// What a ray's walk through hulls costs. Hull hits without any hit of the primitives within are false.
struct HullCounts {
  std::int32_t hullTests = 0;
  std::int32_t hullHits = 0;
  std::int32_t falseHullHits = 0;
  std::int32_t primitiveTests = 0;
  std::int32_t nodes = 0;
  std::int32_t heapPushes = 0;
  std::int32_t heapOverflows = 0;

  friend HullCounts operator+(const HullCounts& a, const HullCounts& b) {
    return {a.hullTests + b.hullTests,           a.hullHits + b.hullHits,
            a.falseHullHits + b.falseHullHits,   a.primitiveTests + b.primitiveTests,
            a.nodes + b.nodes,                   a.heapPushes + b.heapPushes,
            a.heapOverflows + b.heapOverflows};
  }
  friend bool operator==(const HullCounts&, const HullCounts&) = default;
};

}  // namespace twintrace
