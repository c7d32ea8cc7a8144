#include "common/scene/rotation.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace twintrace {

glm::dmat3 rotationMatrix(const glm::vec3& degrees) {
  const glm::dvec3 angle = glm::radians(glm::dvec3(degrees));
  const double cx = std::cos(angle.x), sx = std::sin(angle.x);
  const double cy = std::cos(angle.y), sy = std::sin(angle.y);
  const double cz = std::cos(angle.z), sz = std::sin(angle.z);
  const glm::dmat3 aboutX(1, 0, 0, 0, cx, sx, 0, -sx, cx);
  const glm::dmat3 aboutY(cy, 0, -sy, 0, 1, 0, sy, 0, cy);
  const glm::dmat3 aboutZ(cz, sz, 0, -sz, cz, 0, 0, 0, 1);
  return aboutZ * aboutY * aboutX;
}

/// The angle about x comes from what remains once the turn about z is undone: where y is a right
/// angle, only the two together are determined.
glm::vec3 rotationAngles(const glm::dmat3& r) {
  const double y = std::atan2(-r[0].z, std::hypot(r[0].x, r[0].y));
  const double z = std::atan2(r[0].y, r[0].x);
  const double cz = std::cos(z), sz = std::sin(z);
  const double x = std::atan2(sz * r[2].x - cz * r[2].y, cz * r[1].y - sz * r[1].x);
  return glm::vec3(glm::degrees(glm::dvec3(x, y, z)));
}

}  // namespace twintrace
