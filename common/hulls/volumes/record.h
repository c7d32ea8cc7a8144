#pragma once

#include <bit>

#include "common/hulls/hull_structure.h"

namespace twintrace {

inline glm::uvec4 recordTexel(const glm::vec3& v, float w = 0.0f) {
  return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
          std::bit_cast<std::uint32_t>(v.z), std::bit_cast<std::uint32_t>(w)};
}

inline glm::dvec3 recordVector(const glm::uvec4& texel) {
  return {std::bit_cast<float>(texel.x), std::bit_cast<float>(texel.y),
          std::bit_cast<float>(texel.z)};
}

inline double recordNumber(const glm::uvec4& texel) { return std::bit_cast<float>(texel.w); }

}  // namespace twintrace
