#pragma once

#include <memory>

#include "common/scene/flat_scene.h"
#include "cpu/embree_geometry.h"

namespace twintrace {

/// Embree's own geometry of a scene: what EmbreeCaster documents, ready to be cast at.
class EmbreeWorld {
 public:
  /// @param robust with RTC_SCENE_FLAG_ROBUST, which closes the gaps between triangles
  /// @throws DeviceError if Embree fails.
  EmbreeWorld(const FlatScene& scene, bool robust);

  const EmbreeScene& scene() const { return world_; }

  /// The flat scene's primitive of a hit.
  int primitiveOf(const RTCHit& hit) const;

 private:
  void addSpheres(const FlatScene& scene);
  void addBoxes(const FlatScene& scene);
  void addTriangles(const FlatScene& scene);

  EmbreeDevice device_;
  EmbreeScene world_;
  int firstBox_ = 0;
  int firstTriangle_ = 0;
};

}  // namespace twintrace
