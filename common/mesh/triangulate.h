#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/mesh/mesh.h"

namespace twintrace {

/// The normal of a polygon, as long as its area; of one that is not plane, the mean. Newell's
/// method, Sutherland, Sproull and Schumacker 1974.
glm::dvec3 areaVector(std::span<const glm::vec3> polygon);

/// Of a polygon: cutting it up may take time by the square of its corners.
inline constexpr int kMaxCorners = 16384;

/// What became of a polygon.
enum class Cut {
  clean,    ///< its triangles cover it
  crossed,  ///< it crosses itself: its triangles cover some of it
  nothing   ///< it has no area
};

/// Cuts polygons into triangles, concave ones too, by cutting off ears (Meisters 1975). Changed: a
/// corner that is not convex blocks an ear from its edges too, so that corners in line stay corners
/// of triangles and neighbours that share them don't part; time grows with the number of corners
/// times that of the corners that are not convex.
class PolygonCutter {
 public:
  /// @param polygon at least 3 corners, in a plane or nearly, in either order; corners may coincide
  /// @param first index of its first corner in the mesh
  /// @param triangles gets the polygon's triangles, in its order of corners
  Cut cut(std::span<const glm::vec3> polygon, std::uint32_t first, std::vector<Corners>& triangles);

 private:
  struct Corner {
    glm::dvec2 at;
    std::uint32_t previous;
    std::uint32_t next;
    bool left;  ///< not cut off yet
  };

  void project(std::span<const glm::vec3> polygon, const glm::dvec3& normal);
  double turn(std::uint32_t corner) const;
  bool isEar(std::uint32_t corner) const;
  void remove(std::uint32_t corner);
  void listBlockers();
  bool cutEars(std::uint32_t first, std::vector<Corners>& triangles);
  void cutAnyhow(std::uint32_t first, std::vector<Corners>& triangles);
  void add(std::uint32_t corner, std::uint32_t first, std::vector<Corners>& triangles) const;

  std::vector<Corner> corners_;
  std::vector<std::uint32_t> blockers_;    ///< corners that were not convex
  std::vector<std::uint32_t> candidates_;  ///< corners that may be ears
  std::uint32_t leftCount_ = 0;
};

}  // namespace twintrace
