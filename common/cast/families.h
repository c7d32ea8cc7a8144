#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/cast/case_set.h"

namespace twintrace {

enum class FamilyKind { sphere, box, orientedBox, plane, triangle, scene, bounce };

/// What the answer of a family's rays has to be.
enum class Expectation {
  exact,   ///< what exact arithmetic says
  closed,  ///< the same, and the surface has no gaps: an exact hit is never a miss, however narrow
  escape,  ///< after a bounce: no hit; a hit is the surface hitting itself
  plate    ///< after a bounce: primitive 1, a thin plate above the surface; a miss is a leak
};

/// Rays that are hard for float arithmetic in one way.
struct Family {
  std::string name;
  std::string what;  ///< one line with the numbers
  FamilyKind kind = FamilyKind::sphere;
  Expectation expectation = Expectation::exact;
};

/// All families, in the order of the report.
const std::vector<Family>& families();

/// The family of that name. @throws UsageError with a suggestion if there is none.
const Family& findFamily(std::string_view name);

/// Draws rays with their scenes. A ray depends on name, seed and its number alone, so that a family
/// can be drawn in parts.
/// @param first number of the first ray
/// @throws UsageError if there is no such family.
CaseSet drawFamily(std::string_view name, std::uint32_t count, std::uint64_t seed,
                   std::uint64_t first = 0);

}  // namespace twintrace
