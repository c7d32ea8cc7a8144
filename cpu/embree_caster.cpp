#include "cpu/embree_caster.h"

#include <tbb/blocked_range.h>

#include <cassert>
#include <chrono>

#include "common/base/flush_denormals.h"
#include "common/base/parallel_for.h"
#include "cpu/embree_world.h"
#include "cpu/thread_arena.h"

namespace twintrace {
namespace {

constexpr std::size_t kGrain = 1024;

class Caster : public EmbreeCaster {
 public:
  explicit Caster(std::shared_ptr<const FlatScene> scene)
      : scene_(std::move(scene)), world_(*scene_, true) {}

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
  CastHit castOne(const CastRay& ray) const {
    if (!isEmbreeRay(ray)) return {};
    const RTCRayHit found = castEmbree(world_.scene(), ray);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {found.ray.tfar, world_.primitiveOf(found.hit), normalOf(found.hit)};
  }

  std::shared_ptr<const FlatScene> scene_;
  EmbreeWorld world_;
};

class TimedCaster : public HullCaster {
 public:
  TimedCaster(const FlatScene& scene, bool robust, int threads)
      : world_(scene, robust), arena_(threads) {}

  double cast(std::span<const CastRay> rays, std::span<HullHit> hits) override {
    assert(hits.size() == rays.size());
    const tbb::blocked_range<std::size_t> all(0, rays.size(), kGrain);
    const auto start = std::chrono::steady_clock::now();
    arena_.execute([&] {
      parallelFor(all, [&](const tbb::blocked_range<std::size_t>& part) {
        const FlushDenormals flush;
        for (std::size_t i = part.begin(); i < part.end(); ++i) hits[i] = castOne(rays[i]);
      });
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::vector<HullCounts> count(std::span<const CastRay> rays) override {
    return std::vector<HullCounts>(rays.size());
  }

 private:
  HullHit castOne(const CastRay& ray) const {
    const RTCRayHit found = castEmbree(world_.scene(), ray);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {ray.tmax, layout::kNoPrimitive};
    return {found.ray.tfar, world_.primitiveOf(found.hit)};
  }

  EmbreeWorld world_;
  ThreadArena arena_;
};

}  // namespace

std::unique_ptr<EmbreeCaster> makeEmbreeCaster(std::shared_ptr<const FlatScene> scene) {
  return std::make_unique<Caster>(std::move(scene));
}

std::unique_ptr<HullCaster> makeEmbreeHullCaster(const FlatScene& scene, bool robust, int threads) {
  return std::make_unique<TimedCaster>(scene, robust, threads);
}

std::string embreeVersion() {
  return RTC_VERSION_STRING;
}

}  // namespace twintrace
