#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace twintrace {

/// Whether no component is infinite or NaN.
inline bool isFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace twintrace
