#include "cpu/embree_case_engine.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <numeric>

#include "common/base/error.h"
#include "common/base/flush_denormals.h"
#include "common/base/parallel_for.h"
#include "cpu/embree_geometry.h"

namespace twintrace {
namespace {

constexpr unsigned kSpheres = 0;  // geometry numbers
constexpr unsigned kTriangles = 1;
constexpr std::size_t kGrain = 64;  // scenes per task: some milliseconds of building

/// One case's scene in Embree, with the way back from its elements to the case's primitives.
class EmbreeCase {
 public:
  EmbreeCase(const EmbreeDevice& device, std::span<const CasePrimitive> primitives)
      : scene_(makeEmbreeScene(device)) {
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      add(primitives[i]);
      sphereOwner_.resize(spheres_.size(), static_cast<std::int32_t>(i));
      triangleOwner_.resize(triangles_.indices.size(), static_cast<std::int32_t>(i));
    }
    attachSpheres(device, scene_, kSpheres, spheres_);
    attachTriangles(device, scene_, kTriangles, triangles_);
    commitEmbreeScene(device, scene_);
  }

  CastHit cast(const CastRay& ray) const {
    if (!isEmbreeRay(ray)) return {};
    const RTCRayHit found = castEmbree(scene_, ray);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const auto& owner = found.hit.geomID == kSpheres ? sphereOwner_ : triangleOwner_;
    return {found.ray.tfar, owner[found.hit.primID], normalOf(found.hit)};
  }

 private:
  void add(const CasePrimitive& primitive) {
    switch (primitive.kind) {
      case CaseKind::sphere:
        spheres_.emplace_back(primitive.vector(0), primitive.values[3]);
        break;
      case CaseKind::box:
        triangles_.addBox(primitive.vector(0), primitive.vector(3));
        break;
      case CaseKind::orientedBox:
        triangles_.addOrientedBox(
            primitive.vector(0), {primitive.vector(3), primitive.vector(6), primitive.vector(9)},
            primitive.vector(12));
        break;
      case CaseKind::triangle:
        triangles_.addTriangle(primitive.vector(0), primitive.vector(3), primitive.vector(6));
        break;
      case CaseKind::plane:
        break;
    }
  }

  EmbreeScene scene_;
  std::vector<glm::vec4> spheres_;
  EmbreeTriangles triangles_;
  std::vector<std::int32_t> sphereOwner_;  ///< primitive of each sphere point
  std::vector<std::int32_t> triangleOwner_;
};

/// Indices of the rays, those of the same scene together, otherwise in order.
std::vector<std::uint32_t> sceneOrder(const CaseSet& cases) {
  std::vector<std::uint32_t> order(cases.rays.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return cases.rays[a].scene < cases.rays[b].scene;
  });
  return order;
}

class EmbreeCaseEngine : public CaseEngine {
 public:
  EmbreeCaseEngine() : device_(openEmbreeDevice()) {}

  std::vector<CastHit> cast(const CaseSet& cases) override {
    if (!cases.bounces.empty()) {
      throw UsageError("found cases that bounce, expected none on engine embree");
    }
    std::vector<CastHit> hits(cases.rays.size());
    const std::vector<std::uint32_t> order = sceneOrder(cases);
    const tbb::blocked_range<std::size_t> all(0, order.size(), kGrain);
    parallelFor(all, [&](const tbb::blocked_range<std::size_t>& part) {
      const FlushDenormals flush;
      castPart(cases, std::span(order).subspan(part.begin(), part.size()), hits);
    });
    return hits;
  }

  std::string name() const override { return "embree"; }
  bool canBounce() const override { return false; }
  bool has(CaseKind kind) const override { return kind != CaseKind::plane; }

 private:
  void castPart(const CaseSet& cases, std::span<const std::uint32_t> order,
                std::vector<CastHit>& hits) const {
    std::unique_ptr<const EmbreeCase> scene;
    std::uint32_t built = 0;
    for (const std::uint32_t index : order) {
      const CaseRay& ray = cases.rays[index];
      if (!scene || built != ray.scene) {
        scene = std::make_unique<EmbreeCase>(device_, cases.primitivesOf(ray));
        built = ray.scene;
      }
      hits[index] = scene->cast(normalised(ray.ray));
    }
  }

  EmbreeDevice device_;
};

}  // namespace

std::unique_ptr<CaseEngine> makeEmbreeCaseEngine() {
  return std::make_unique<EmbreeCaseEngine>();
}

}  // namespace twintrace
