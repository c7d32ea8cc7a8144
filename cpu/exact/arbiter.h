#pragma once

#include <cstdint>
#include <vector>

#include "common/cast/case_set.h"
#include "common/cast/exact_hit.h"

namespace twintrace {

/// How often the arbiter's floating-point filter could not tell and exact numbers decided.
struct ArbiterEffort {
  std::uint64_t primitives = 0;        ///< primitives tested
  std::uint64_t exactPrimitives = 0;   ///< of these, decided by exact numbers
  std::uint64_t exactComparisons = 0;  ///< orders of two hits along a ray decided by exact numbers
  std::uint64_t exactDistances = 0;    ///< values of t computed from exact numbers

  ArbiterEffort& operator+=(const ArbiterEffort& other);
};

/// The closest hit of each ray in exact arithmetic over its float inputs, in the order of the rays:
/// smallest t in the closed interval [tmin, tmax] but not beyond the largest float, ties to the
/// first primitive. Bounces are left out. A direction of zeros, a NaN, an infinite origin or
/// direction, a triangle without area and a plane or triangle along the ray are misses. Runs on all
/// cores.
///
/// Decisions and their order are exact; normal, tUnit and clarity are computed in double. See
/// clarity.h for what counts as clean.
/// @param effort if given, what it took is added to it
std::vector<ExactHit> arbitrate(const CaseSet& cases, ArbiterEffort* effort = nullptr);

}  // namespace twintrace
