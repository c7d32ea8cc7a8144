#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace twintrace {

/// Vertices of a triangle, as indices.
using Corners = std::array<std::uint32_t, 3>;

/// Triangles over shared vertices, two-sided; the geometric normal is along (b - a) x (c - a).
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;             ///< by vertex, for smooth shading; or empty
  std::vector<glm::vec2> textureCoordinates;  ///< by vertex; or empty
  std::vector<Corners> triangles;
};

}  // namespace twintrace
