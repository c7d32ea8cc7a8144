#include "cpu/embree_device.h"

#include <string>

#include "common/base/error.h"

namespace twintrace {
namespace {

/// The thread sanitizer can't see how Embree, which is not built for it, hands work from thread to
/// thread; one thread has nothing to hand over. Rays are cast by our own threads all the same.
#if defined(__SANITIZE_THREAD__)
constexpr const char* kDeviceConfig = "threads=1";
#else
constexpr const char* kDeviceConfig = nullptr;
#endif

void throwOnError(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE) {
    throw DeviceError("Embree failed with error code " + std::to_string(int(error)));
  }
}

}  // namespace

EmbreeDevice openEmbreeDevice() {
  EmbreeDevice device(rtcNewDevice(kDeviceConfig));
  throwOnError(device.get());
  if (!device) throw DeviceError("Embree failed to start");
  return device;
}

EmbreeScene makeEmbreeScene(const EmbreeDevice& device, bool robust) {
  EmbreeScene scene(rtcNewScene(device.get()));
  rtcSetSceneFlags(scene.get(), robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  return scene;
}

void attachEmbreeGeometry(const EmbreeScene& scene, const EmbreeGeometry& geometry, unsigned id) {
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(scene.get(), geometry.get(), id);
}

void commitEmbreeScene(const EmbreeDevice& device, const EmbreeScene& scene) {
  rtcCommitScene(scene.get());
  throwOnError(device.get());
}

EmbreeContext makeEmbreeContext() {
  EmbreeContext context;
#if RTC_VERSION_MAJOR >= 4
  rtcInitRayQueryContext(&context);
#else
  rtcInitIntersectContext(&context);
#endif
  return context;
}

RTCRayHit makeEmbreeQuery(const glm::vec3& origin, const glm::vec3& direction, float tnear,
                          float tfar) {
  RTCRayHit query{};
  query.ray.org_x = origin.x;
  query.ray.org_y = origin.y;
  query.ray.org_z = origin.z;
  query.ray.dir_x = direction.x;
  query.ray.dir_y = direction.y;
  query.ray.dir_z = direction.z;
  query.ray.tnear = tnear;
  query.ray.tfar = withoutNegativeZero(tfar);
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return query;
}

void intersectEmbree(const EmbreeScene& scene, EmbreeContext& context, RTCRayHit& query) {
#if RTC_VERSION_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene.get(), &query, &arguments);
#else
  rtcIntersect1(scene.get(), &context, &query);
#endif
}

}  // namespace twintrace
