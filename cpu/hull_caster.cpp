#include "cpu/hull_caster.h"

#include <tbb/blocked_range.h>

#include <cassert>
#include <chrono>

#include "common/base/flush_denormals.h"
#include "common/base/parallel_for.h"
#include "cpu/hull_walk.h"
#include "cpu/thread_arena.h"

namespace twintrace {
namespace {

/// Rays per task: even without hulls enough to keep all threads busy to the end.
constexpr std::size_t kGrain = 256;

template <class Number>
HullQueryRay<Number> queryRay(const CastRay& ray) {
  const auto number = [](float x) { return static_cast<Number>(x); };
  return {{number(ray.origin.x), number(ray.origin.y), number(ray.origin.z)},
          {number(ray.direction.x), number(ray.direction.y), number(ray.direction.z)},
          number(ray.tmin),
          number(ray.tmax)};
}

template <class Number>
class CpuHullCaster : public HullCaster {
 public:
  CpuHullCaster(std::shared_ptr<const FlatScene> scene, const RenderOptions& options)
      : scene_(std::move(scene)),
        query_(options.hull == "embree" ? makeHullQuery(*scene_, options)
                                        : makeHullWalk(*scene_, options)),
        arena_(options.threads) {}

  double cast(std::span<const CastRay> rays, std::span<HullHit> hits) override {
    assert(hits.size() == rays.size());
    const auto start = std::chrono::steady_clock::now();
    forEach(rays.size(), [&](std::size_t i) {
      const HullQueryRay<Number> ray = queryRay<Number>(rays[i]);
      Number t = ray.tmax;
      const int primitive = query_->closest(ray, t);
      hits[i] = {static_cast<float>(t), primitive};
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::vector<HullCounts> count(std::span<const CastRay> rays) override {
    std::vector<HullCounts> counts(rays.size());
    forEach(rays.size(),
            [&](std::size_t i) { query_->count(queryRay<Number>(rays[i]), counts[i]); });
    return counts;
  }

 private:
  template <class Action>
  void forEach(std::size_t count, const Action& action) {
    const tbb::blocked_range<std::size_t> all(0, count, kGrain);
    arena_.execute([&] {
      parallelFor(all, [&](const tbb::blocked_range<std::size_t>& part) {
        const FlushDenormals flush;
        for (std::size_t i = part.begin(); i < part.end(); ++i) action(i);
      });
    });
  }

  std::shared_ptr<const FlatScene> scene_;
  std::unique_ptr<HullQuery> query_;
  ThreadArena arena_;
};

}  // namespace

std::unique_ptr<HullCaster> makeCpuHullCaster(std::shared_ptr<const FlatScene> scene,
                                              const RenderOptions& options) {
  if (options.precision == Precision::float64) {
    return std::make_unique<CpuHullCaster<double>>(std::move(scene), options);
  }
  return std::make_unique<CpuHullCaster<float>>(std::move(scene), options);
}

}  // namespace twintrace
