#include "cpu/kernel_caster.h"

#include <tbb/blocked_range.h>

#include "common/base/finite.h"
#include "common/base/parallel_for.h"
#include "cpu/hull_walk.h"
#include "common/base/flush_denormals.h"
#include "cpu/kernel/hit_surface.h"
#include "cpu/kernel/traverse.h"
#include "cpu/kernel_vectors.h"
#include "cpu/thread_arena.h"

namespace twintrace {
namespace {

/// Rays per task: some 100 microseconds of work even in small scenes.
constexpr std::size_t kGrain = 1024;

/// Whether the primitive tests are made for the ray: slabs drop NaN, as if that axis were always
/// inside. A direction of zeros needs no test, since all its t are infinite or NaN, nor does an
/// interval that is empty or NaN.
bool isCastable(const CastRay& ray) {
  return isFinite(ray.origin) && isFinite(ray.direction);
}

template <class R>
CastHit castOne(const kernel::SceneView& scene, const CastRay& ray) {
  if (!isCastable(ray)) return {};
  // An infinite end would make a miss, t = infinity, a hit at the end of the closed interval.
  const R tmax(std::min(ray.tmax, kernel::kLargest));
  const kernel::Ray<R> kernelRay =
      kernel::makeRay(toKernel<R>(ray.origin), toKernel<R>(ray.direction), R(ray.tmin), tmax);
  const kernel::Hit<R> hit = kernel::closestHit(scene, kernelRay);
  if (hit.primitive == kernel::kNoPrimitive) return {};
  const kernel::Vec3<R> normal = kernel::surfaceAt(scene, kernelRay, hit).normal;
  return {toFloat(hit.t), hit.primitive, toFloats(normal)};
}

template <class R>
class KernelCaster : public RayCaster {
 public:
  KernelCaster(std::shared_ptr<const FlatScene> scene, const RenderOptions& options)
      : scene_(std::move(scene)),
        hull_(makeHullQuery(*scene_, options)),
        view_(kernel::viewScene(*scene_, options, hull_.get())),
        arena_(options.threads) {}

  std::vector<CastHit> cast(std::span<const CastRay> rays) override {
    std::vector<CastHit> hits(rays.size());
    const tbb::blocked_range<std::size_t> all(0, rays.size(), kGrain);
    arena_.execute([&] {
      parallelFor(all, [&](const tbb::blocked_range<std::size_t>& part) {
        const FlushDenormals flush;
        for (std::size_t i = part.begin(); i < part.end(); ++i) {
          hits[i] = castOne<R>(view_, rays[i]);
        }
      });
    });
    return hits;
  }

  std::string name() const override { return std::is_same_v<R, double> ? "cpu64" : "cpu"; }

 private:
  std::shared_ptr<const FlatScene> scene_;
  std::unique_ptr<HullQuery> hull_;
  kernel::SceneView view_;
  ThreadArena arena_;
};

}  // namespace

std::unique_ptr<RayCaster> makeKernelCaster(std::shared_ptr<const FlatScene> scene,
                                            const RenderOptions& options) {
  if (options.precision == Precision::float64) {
    return std::make_unique<KernelCaster<double>>(std::move(scene), options);
  }
  if (options.maths == Maths::native) {
    return std::make_unique<KernelCaster<kernel::NativeFloat>>(std::move(scene), options);
  }
  return std::make_unique<KernelCaster<float>>(std::move(scene), options);
}

}  // namespace twintrace
