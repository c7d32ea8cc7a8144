#include "cpu/embree_caster.h"

#include <tbb/blocked_range.h>

#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "common/base/parallel_for.h"
#include "cpu/embree_device.h"
#include "common/base/flush_denormals.h"
#include "cpu/kernel/scene_access.h"

namespace twintrace {
namespace {

constexpr unsigned kSpheres = 0;  // geometry numbers
constexpr unsigned kBoxes = 1;
constexpr int kTrianglesPerBox = 12;
constexpr std::size_t kGrain = 1024;

/// Corner i of a box has its maximum on x, y, z where bit 0, 1, 2 of i is set. Counterclockwise as
/// seen from outside, so that normals point outward.
constexpr std::array<unsigned, 3 * kTrianglesPerBox> kBoxCorners = {
    0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,   // -x, +x
    0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,   // -y, +y
    0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};  // -z, +z

struct Triangles {
  std::vector<glm::vec3> vertices;
  std::vector<glm::uvec3> indices;
};

glm::dvec3 toDouble(const kernel::Vec3<float>& v) {
  return {v.x, v.y, v.z};
}

void addTriangles(Triangles& triangles) {
  const auto first = static_cast<unsigned>(triangles.vertices.size()) - 8u;
  for (std::size_t i = 0; i < kBoxCorners.size(); i += 3) {
    triangles.indices.emplace_back(first + kBoxCorners[i], first + kBoxCorners[i + 1],
                                   first + kBoxCorners[i + 2]);
  }
}

void addBox(Triangles& triangles, const kernel::Box<float>& box) {
  for (int i = 0; i < 8; ++i) {
    triangles.vertices.emplace_back(i & 1 ? box.maximum.x : box.minimum.x,
                                    i & 2 ? box.maximum.y : box.minimum.y,
                                    i & 4 ? box.maximum.z : box.minimum.z);
  }
  addTriangles(triangles);
}

void addBox(Triangles& triangles, const kernel::OrientedBox<float>& box) {
  const glm::dvec3 x = toDouble(box.axisX) * double(box.halfSize.x);
  const glm::dvec3 y = toDouble(box.axisY) * double(box.halfSize.y);
  const glm::dvec3 z = toDouble(box.axisZ) * double(box.halfSize.z);
  for (int i = 0; i < 8; ++i) {
    triangles.vertices.emplace_back(toDouble(box.center) + (i & 1 ? x : -x) + (i & 2 ? y : -y) +
                                    (i & 4 ? z : -z));
  }
  addTriangles(triangles);
}

bool isFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What Embree asks of a ray; else its answer is undefined.
bool isCastable(const CastRay& ray) {
  return isFinite(ray.origin) && isFinite(ray.direction) && ray.direction != glm::vec3(0.0f) &&
         ray.tmin <= ray.tmax;
}

/// A geometry's buffer of `count` elements, filled from `data`.
template <class T>
void fillBuffer(const EmbreeGeometry& geometry, RTCBufferType type, RTCFormat format,
                const std::vector<T>& data) {
  void* buffer = rtcSetNewGeometryBuffer(geometry.get(), type, 0, format, sizeof(T), data.size());
  if (buffer != nullptr) std::copy(data.begin(), data.end(), static_cast<T*>(buffer));
}

class Caster : public EmbreeCaster {
 public:
  explicit Caster(std::shared_ptr<const FlatScene> scene)
      : scene_(std::move(scene)), device_(openEmbreeDevice()), world_(makeEmbreeScene(device_)) {
    const kernel::SceneView view = kernel::viewScene(*scene_, RenderOptions{}, nullptr);
    attachSpheres(view);
    attachBoxes(view);
    commitEmbreeScene(device_, world_);
  }

  std::vector<CastHit> cast(std::span<const CastRay> rays) override {
    std::vector<CastHit> hits(rays.size());
    const tbb::blocked_range<std::size_t> all(0, rays.size(), kGrain);
    parallelFor(all, [&](const tbb::blocked_range<std::size_t>& part) {
      const FlushDenormals flush;
      for (std::size_t i = part.begin(); i < part.end(); ++i) hits[i] = castOne(rays[i]);
    });
    return hits;
  }

  std::string name() const override { return "embree"; }
  int leftOut() const override { return scene_->index.planeCount; }

 private:
  void attachSpheres(const kernel::SceneView& view) {
    std::vector<glm::vec4> points;
    for (int i = 0; view.effectSphere && i < view.index.sphereCount; ++i) {
      const kernel::Sphere<float> sphere = kernel::fetchSphere<float>(view, i);
      points.emplace_back(sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius);
    }
    if (points.empty()) return;
    const EmbreeGeometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT));
    fillBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, points);
    attachEmbreeGeometry(world_, geometry, kSpheres);
  }

  void attachBoxes(const kernel::SceneView& view) {
    Triangles triangles;
    for (int i = 0; view.effectBox && i < view.index.boxCount; ++i) {
      addBox(triangles, kernel::fetchBox<float>(view, i));
    }
    firstBox_ = view.index.sphereCount + (view.effectBox ? 0 : view.index.boxCount);
    for (int i = 0; view.effectOrientedBox && i < view.index.orientedBoxCount; ++i) {
      addBox(triangles, kernel::fetchOrientedBox<float>(view, i));
    }
    if (triangles.indices.empty()) return;
    const EmbreeGeometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    fillBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, triangles.vertices);
    fillBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles.indices);
    attachEmbreeGeometry(world_, geometry, kBoxes);
  }

  CastHit castOne(const CastRay& ray) const {
    if (!isCastable(ray)) return {};
    EmbreeContext context = makeEmbreeContext();
    RTCRayHit query =
        makeEmbreeQuery(ray.origin, ray.direction, std::max(ray.tmin, 0.0f), ray.tmax);
    intersectEmbree(world_, context, query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const auto element = static_cast<int>(query.hit.primID);
    const int primitive =
        query.hit.geomID == kSpheres ? element : firstBox_ + element / kTrianglesPerBox;
    const glm::dvec3 normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
    return {query.ray.tfar, primitive, glm::vec3(glm::normalize(normal))};
  }

  std::shared_ptr<const FlatScene> scene_;
  EmbreeDevice device_;
  EmbreeScene world_;
  int firstBox_ = 0;
};

}  // namespace

std::unique_ptr<EmbreeCaster> makeEmbreeCaster(std::shared_ptr<const FlatScene> scene) {
  return std::make_unique<Caster>(std::move(scene));
}

std::string embreeVersion() {
  return RTC_VERSION_STRING;
}

}  // namespace twintrace
