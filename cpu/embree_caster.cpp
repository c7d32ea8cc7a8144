#include "cpu/embree_caster.h"

#include <tbb/blocked_range.h>

#include "common/base/flush_denormals.h"
#include "common/base/parallel_for.h"
#include "cpu/embree_geometry.h"
#include "cpu/kernel/scene_access.h"

namespace twintrace {
namespace {

constexpr unsigned kSpheres = 0;  // geometry numbers
constexpr unsigned kBoxes = 1;
constexpr std::size_t kGrain = 1024;

glm::vec3 toGlm(const kernel::Vec3<float>& v) {
  return {v.x, v.y, v.z};
}

class Caster : public EmbreeCaster {
 public:
  explicit Caster(std::shared_ptr<const FlatScene> scene)
      : scene_(std::move(scene)), device_(openEmbreeDevice()), world_(makeEmbreeScene(device_)) {
    const kernel::SceneView view = kernel::viewScene(*scene_, RenderOptions{}, nullptr);
    addSpheres(view);
    addBoxes(view);
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
  void addSpheres(const kernel::SceneView& view) {
    std::vector<glm::vec4> points;
    for (int i = 0; view.effectSphere && i < view.index.sphereCount; ++i) {
      const kernel::Sphere<float> sphere = kernel::fetchSphere<float>(view, i);
      points.emplace_back(toGlm(sphere.center), sphere.radius);
    }
    attachSpheres(device_, world_, kSpheres, points);
  }

  void addBoxes(const kernel::SceneView& view) {
    EmbreeTriangles triangles;
    for (int i = 0; view.effectBox && i < view.index.boxCount; ++i) {
      const kernel::Box<float> box = kernel::fetchBox<float>(view, i);
      triangles.addBox(toGlm(box.minimum), toGlm(box.maximum));
    }
    firstBox_ = view.index.sphereCount + (view.effectBox ? 0 : view.index.boxCount);
    for (int i = 0; view.effectOrientedBox && i < view.index.orientedBoxCount; ++i) {
      const kernel::OrientedBox<float> box = kernel::fetchOrientedBox<float>(view, i);
      triangles.addOrientedBox(toGlm(box.center),
                               {toGlm(box.axisX), toGlm(box.axisY), toGlm(box.axisZ)},
                               toGlm(box.halfSize));
    }
    attachTriangles(device_, world_, kBoxes, triangles);
  }

  CastHit castOne(const CastRay& ray) const {
    if (!isEmbreeRay(ray)) return {};
    const RTCRayHit found = castEmbree(world_, ray);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const auto element = static_cast<int>(found.hit.primID);
    const int primitive =
        found.hit.geomID == kSpheres ? element : firstBox_ + element / kTrianglesPerBox;
    return {found.ray.tfar, primitive, normalOf(found.hit)};
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
