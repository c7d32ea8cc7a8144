#pragma once

#include <memory>
#include <string>

#include "common/hulls/hull_caster.h"
#include "common/scene/flat_scene.h"
#include "common/trace/ray_caster.h"

namespace twintrace {

/// The witness: Embree's own geometry of the scene. Spheres are its sphere points, boxes and
/// oriented boxes 12 triangles each; planes, which it lacks, and what the scene's effects leave out
/// are left out. Primitives are the flat scene's; among hits of equal t any may be returned.
class EmbreeCaster : public RayCaster {
 public:
  /// Planes of the scene that it does not see.
  virtual int leftOut() const = 0;
};

/// Embree has no negative t: a ray's interval is cut to t >= 0. Rays that are not numbers, or
/// infinite, or have no direction, miss.
/// @throws DeviceError if Embree fails.
std::unique_ptr<EmbreeCaster> makeEmbreeCaster(std::shared_ptr<const FlatScene> scene);

/// The witness as something to be measured: rtcIntersect1, ray by ray. It counts nothing.
/// @param robust with RTC_SCENE_FLAG_ROBUST
/// @param threads 0 = one per core
std::unique_ptr<HullCaster> makeEmbreeHullCaster(const FlatScene& scene, bool robust, int threads);

/// Version of the Embree library that this program was built with.
std::string embreeVersion();

}  // namespace twintrace
