#pragma once

#include <glm/vec3.hpp>

#include "common/mesh/mesh.h"

namespace twintrace {

/// The sides that a cone or cylinder gets.
inline constexpr int kConeSides = 64;

/// Adds the mantle of a cone, of a truncated one or of a cylinder as kConeSides flat sides with
/// smooth normals; no caps. Its vertices lie on the cone.
/// @param base and apex ends of the axis, apart from each other
/// @param baseRadius and apexRadius at least 0, not both 0
void addCone(Mesh& mesh, const glm::dvec3& base, double baseRadius, const glm::dvec3& apex,
             double apexRadius);

/// How far the sides lie inside the cone where its radius is this, at most.
double coneChordError(double radius);

}  // namespace twintrace
