#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace twintrace {

/// All points p with normal . p <= offset.
struct HalfSpace {
  glm::dvec3 normal;  ///< of any length
  double offset = 0.0;
};

struct PolytopeMeasure {
  double area = 0.0;
  double content = 0.0;
};

/// Surface area and volume of an intersection of half-spaces that is bounded, by cutting each face out of
/// a large square.
PolytopeMeasure measurePolytope(std::span<const HalfSpace> spaces);

}  // namespace twintrace
