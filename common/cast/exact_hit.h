#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace twintrace {

/// How sure a ray's exact answer is against small changes of its inputs.
enum class Clarity : std::uint8_t {
  clean,      ///< no change of 8 ulp of the largest coordinate involved alters which surface is hit
  ambiguous,  ///< some such change does
  tie         ///< two primitives are hit at exactly the same t
};

/// Another face of a box beside the edge near which the ray hit it: it would be the one that is hit
/// if both faces moved by 8 ulp of the largest coordinate involved.
struct FaceBeside {
  double t = 0.0;  ///< where the ray crosses its plane
  double tUnit = 0.0;
  glm::dvec3 normal{0.0};
};

/// The closest hit in exact arithmetic over float inputs taken as exact.
struct ExactHit {
  std::int32_t primitive = -1;  ///< index within the ray's scene; -1 is a miss
  bool leaving = false;         ///< whether the exit surface was hit, as from inside
  Clarity clarity = Clarity::clean;
  double t = 0.0;               ///< within 1 ulp of the exact value
  double tUnit = 0.0;           ///< change of t when the surface moves by 1 ulp of the largest coordinate
  glm::dvec3 normal{0.0};       ///< as CaseEngine says, in double
  std::vector<FaceBeside> facesBeside;  ///< none but near a box's edge
};

}  // namespace twintrace
