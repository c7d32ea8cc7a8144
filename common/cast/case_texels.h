#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "common/cast/case_set.h"

namespace twintrace {

/// Where a case's scene lies in the texels.
struct CaseRange {
  std::int32_t firstTexel = 0;
  std::int32_t count = 0;  ///< primitives
  float reach = 0.0f;      ///< largest absolute coordinate or length of them
};

/// A case set's primitives as the kernels read them. Layout: shaders/shared/layout.glsl.
struct CaseTexels {
  std::vector<glm::uvec4> texels;
  std::vector<CaseRange> scenes;  ///< by index of the scene
};

/// @throws UsageError for more primitives than an index into texels can reach.
CaseTexels packCases(const CaseSet& cases);

}  // namespace twintrace
