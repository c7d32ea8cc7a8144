#pragma once

// Case sets of one ray, and what the arbiter says to them.

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "cpu/exact/arbiter.h"

namespace twintrace::test {

inline CasePrimitive primitive(CaseKind kind, std::initializer_list<float> values) {
  CasePrimitive result{kind, {}};
  std::copy(values.begin(), values.end(), result.values.begin());
  return normalised(result);
}

inline CaseSet casesOf(const std::vector<CasePrimitive>& primitives, const CastRay& ray) {
  CaseSet cases;
  cases.primitives = primitives;
  cases.scenes = {{0, static_cast<std::uint32_t>(primitives.size())}};
  cases.rays = {{ray, 0}};
  return cases;
}

inline ExactHit decide(const std::vector<CasePrimitive>& primitives, const CastRay& ray) {
  return arbitrate(casesOf(primitives, ray)).at(0);
}

}  // namespace twintrace::test
