#include "cpu/case_engine.h"

#include <tbb/blocked_range.h>

#include "common/base/flush_denormals.h"
#include "common/base/parallel_for.h"
#include "common/cast/case_texels.h"
#include "cpu/kernel/cases.h"
#include "cpu/kernel_vectors.h"
#include "cpu/thread_arena.h"

namespace twintrace {
namespace {

static_assert(kBounceNotStarted == layout::kCaseNotStarted);

/// Rays per task: some 100 microseconds of work in scenes of one primitive.
constexpr std::size_t kGrain = 512;

template <class R>
kernel::CaseQuery<R> queryOf(const CastRay& ray, const CaseRange& range) {
  return {toKernel<R>(ray.origin), toKernel<R>(ray.direction), R(ray.tmin), R(ray.tmax),
          R(range.reach),          range.firstTexel,           range.count};
}

template <class R>
CastHit hitOf(const kernel::CaseAnswer<R>& answer) {
  return {toFloat(answer.t), answer.primitive, toFloats(answer.normal)};
}

template <class R>
class KernelCaseEngine : public CaseEngine {
 public:
  explicit KernelCaseEngine(const RenderOptions& options) : arena_(options.threads) {
    view_.intersectorReport = options.intersector == Intersector::report;
  }

  std::vector<CastHit> cast(const CaseSet& cases) override {
    const CaseTexels packed = packCases(cases);
    kernel::SceneView view = view_;
    view.words = packed.texels.empty() ? nullptr : &packed.texels[0].x;
    std::vector<CastHit> hits(cases.rays.size());
    const tbb::blocked_range<std::size_t> all(0, hits.size(), kGrain);
    arena_.execute([&] {
      parallelFor(all, [&](const tbb::blocked_range<std::size_t>& part) {
        const FlushDenormals flush;
        for (std::size_t i = part.begin(); i < part.end(); ++i) {
          hits[i] = castOne(view, cases, packed, i);
        }
      });
    });
    return hits;
  }

  std::string name() const override { return std::is_same_v<R, double> ? "cpu64" : "cpu"; }

 private:
  static CastHit castOne(const kernel::SceneView& view, const CaseSet& cases,
                         const CaseTexels& packed, std::size_t index) {
    const CaseRay& ray = cases.rays[index];
    const auto query = queryOf<R>(normalised(ray.ray), packed.scenes[ray.scene]);
    if (cases.bounces.empty()) return hitOf(kernel::castQuery(view, query));
    const Bounce& bounce = cases.bounces[index];
    return hitOf(kernel::castBounce(view, query, R(bounce.x), R(bounce.y)));
  }

  kernel::SceneView view_;
  ThreadArena arena_;
};

}  // namespace

std::unique_ptr<CaseEngine> makeKernelCaseEngine(const RenderOptions& options) {
  if (options.precision == Precision::float64) {
    return std::make_unique<KernelCaseEngine<double>>(options);
  }
  if (options.maths == Maths::native) {
    return std::make_unique<KernelCaseEngine<kernel::NativeFloat>>(options);
  }
  return std::make_unique<KernelCaseEngine<float>>(options);
}

}  // namespace twintrace
