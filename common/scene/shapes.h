#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>

namespace twintrace {

struct Parts;

struct SphereShape {
  glm::vec3 center{0.0f};
  float radius = 1.0f;
};

/// A box with full size along its own axes; rotation (degrees) turns about x, then y, then z.
/// In double, so that faces authored as minimum and maximum come out as the floats that were written.
struct BoxShape {
  glm::dvec3 center{0.0};
  glm::dvec3 size{1.0};
  std::optional<glm::vec3> rotation;

  /// Whether it is an oriented box: a rotation by nothing leaves it aligned.
  bool isTurned() const { return rotation && *rotation != glm::vec3(0.0f); }
};

struct PlaneShape {
  glm::vec3 point{0.0f};
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
};

/// Where the author puts a whole: scaled, turned about x, then y, then z, and moved.
struct Placement {
  float scale = 1.0f;
  glm::vec3 rotation{0.0f};  ///< degrees
  glm::vec3 translation{0.0f};
};

/// Triangles of a file, and spheres of an NFF file. The parts are the file's, in place; null until
/// expandShapes has read it.
struct MeshShape {
  std::string file;         ///< as resolved against the scene file
  std::optional<int> part;  ///< only what has the file's material, or fill, of this number
  Placement placement;
  bool smooth = false;  ///< shade with the file's normals, or with means of the triangles' at vertices
  std::shared_ptr<const Parts> parts;
};

/// What a generator makes; its parts are null until expandShapes has made them.
struct GeneratedShape {
  std::string generator;
  int size = 0;
  std::uint32_t seed = 1;
  Placement placement;
  std::shared_ptr<const Parts> parts;
};

}  // namespace twintrace
