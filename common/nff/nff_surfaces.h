#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/mesh/triangulate.h"
#include "common/nff/nff_file.h"

namespace twintrace {

/// Collects the surfaces of an NFF file by their fills, and counts what is odd about them.
class NffSurfaces {
 public:
  /// The fill of what comes next.
  void setFill(const NffFill& fill);
  bool hasFill() const { return current_ != nullptr; }

  /// A radius below 0 stands for a surface that is visible from inside alone.
  void addSphere(const glm::vec3& center, float radius);
  void addCone(const glm::vec3& base, float baseRadius, const glm::vec3& apex, float apexRadius);
  /// @param normals by corner, or none
  void addPolygon(std::span<const glm::vec3> corners, std::span<const glm::vec3> normals);

  /// Spheres and triangles so far.
  std::int64_t primitiveCount() const { return primitiveCount_; }

  /// The parts by fill, and the warnings.
  void moveInto(NffFile& file);

 private:
  struct Oddities {
    std::int64_t flatPolygons = 0;
    std::int64_t crossedPolygons = 0;
    std::int64_t pointSpheres = 0;
    std::int64_t flatCones = 0;
    std::int64_t insides = 0;
    std::int64_t cones = 0;
    double chordError = 0.0;
  };
  struct FillOrder {
    bool operator()(const NffFill& a, const NffFill& b) const;
  };

  void addNormals(std::span<const glm::vec3> corners, std::span<const glm::vec3> normals);
  std::vector<std::string> warnings() const;

  std::vector<NffPart> parts_;
  std::map<NffFill, std::size_t, FillOrder> indices_;
  NffPart* current_ = nullptr;
  std::int64_t primitiveCount_ = 0;
  Oddities oddities_;
  PolygonCutter cutter_;
};

}  // namespace twintrace
