#pragma once

// Embree 3 and 4 behind one set of names. Only cpu/embree_*.cpp include this file, and no other
// file includes rtcore.h.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <glm/vec3.hpp>
#include <memory>

namespace twintrace {

#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;
#else
using EmbreeContext = RTCIntersectContext;
#endif

struct EmbreeRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using EmbreeDevice = std::unique_ptr<std::remove_pointer_t<RTCDevice>, EmbreeRelease>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, EmbreeRelease>;
using EmbreeGeometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, EmbreeRelease>;

/// @throws DeviceError if Embree does not start.
EmbreeDevice openEmbreeDevice();

/// An empty scene with Embree's robust traversal and triangle tests.
EmbreeScene makeEmbreeScene(const EmbreeDevice& device, bool robust = true);

/// Commits a geometry and attaches it as `id`.
void attachEmbreeGeometry(const EmbreeScene& scene, const EmbreeGeometry& geometry, unsigned id);

/// Builds the tree.
/// @throws DeviceError with Embree's error, of this call or of an earlier one on the device.
void commitEmbreeScene(const EmbreeDevice& device, const EmbreeScene& scene);

EmbreeContext makeEmbreeContext();

/// A distance as Embree may get it: it compares tfar as an integer somewhere, so that -0 lies
/// before everything (seen with 3.13.5: such rays hit nothing).
inline float withoutNegativeZero(float t) {
  return t + 0.0f;
}

/// A query without a hit yet.
/// @param tnear at least 0, as Embree demands
RTCRayHit makeEmbreeQuery(const glm::vec3& origin, const glm::vec3& direction, float tnear,
                          float tfar);

/// Closest hit; `context` is what callbacks get.
void intersectEmbree(const EmbreeScene& scene, EmbreeContext& context, RTCRayHit& query);

}  // namespace twintrace
