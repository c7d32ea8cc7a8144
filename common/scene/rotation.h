#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace twintrace {

/// Turns about x, then y, then z. @param degrees about each axis
glm::dmat3 rotationMatrix(const glm::vec3& degrees);

/// The angles of a rotation, in degrees.
glm::vec3 rotationAngles(const glm::dmat3& rotation);

}  // namespace twintrace
