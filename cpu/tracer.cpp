#include "cpu/tracer.h"

#include <tbb/blocked_range2d.h>

#include <cassert>
#include <chrono>

#include "common/base/error.h"
#include "common/base/parallel_for.h"
#include "common/hulls/hull_structure.h"
#include "cpu/hull_walk.h"
#include "cpu/kernel_entry.h"
#include "cpu/thread_arena.h"

namespace twintrace {

InstructionSet bestInstructionSet() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("x86-64-v4")) return InstructionSet::avx512;
  if (__builtin_cpu_supports("x86-64-v3")) return InstructionSet::avx2;
  return InstructionSet::sse2;
}

const char* instructionSetName(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::sse2:
      break;
  }
  return "sse2";
}

int laneCount(InstructionSet set) {
  return set == InstructionSet::avx512 ? 16 : set == InstructionSet::avx2 ? 8 : 4;
}

Lanes chosenLanes(const RenderOptions& options) {
  if (options.lanes == Lanes::scalar) return Lanes::scalar;
  const bool possible =
      options.maths == Maths::strict && options.precision == Precision::float32;
  if (possible) return Lanes::wide;
  if (options.lanesGiven) {
    throw UsageError("lanes wide exist for maths strict in precision float only; expected lanes "
                     "scalar with maths native or precision double");
  }
  return Lanes::scalar;
}

namespace {

TileKernel chooseKernel(const RenderOptions& options, Lanes lanes, InstructionSet set) {
  const ScalarKernels scalar =
      set == InstructionSet::sse2 ? scalarKernelsBaseline() : scalarKernelsAvx2();
  if (options.precision == Precision::float64) return scalar.float64;
  if (options.maths == Maths::native) return scalar.native;
  if (lanes == Lanes::scalar) return scalar.strict;
  switch (set) {
    case InstructionSet::avx512:
      return renderTileAvx512;
    case InstructionSet::avx2:
      return renderTileAvx2;
    case InstructionSet::sse2:
      break;
  }
  return renderTileSse2;
}

class CpuRenderer : public Renderer {
 public:
  CpuRenderer(std::shared_ptr<const FlatScene> scene, const RenderOptions& options,
              const CpuTracerSettings& settings)
      : scene_(std::move(scene)),
        options_(options),
        settings_(settings),
        lanes_(chosenLanes(options)),
        kernel_(chooseKernel(options, lanes_, settings.instructionSet)),
        arena_(options.threads) {
    hull_ = makeHullQuery(*scene_, options);
  }

  double renderFrame(std::uint32_t firstSample, int passes, std::span<float> sums) override {
    assert(sums.size() == std::size_t{3} * scene_->width * scene_->height);
    const FrameJob job{scene_.get(), &options_, hull_.get(), firstSample, passes, sums.data()};
    const auto size = static_cast<std::size_t>(settings_.tileSize);
    const tbb::blocked_range2d<int> pixels(0, scene_->height, size, 0, scene_->width, size);
    const auto start = std::chrono::steady_clock::now();
    arena_.execute([&] {
      parallelFor(
          pixels,
          [&](const tbb::blocked_range2d<int>& part) {
            kernel_(job, Tile{part.cols().begin(), part.rows().begin(), part.cols().end(),
                              part.rows().end()});
          },
          tbb::simple_partitioner());
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  Provenance provenance() const override {
    const bool wide = lanes_ == Lanes::wide;
    return {{"backend", "cpu"},
            {"lanes", wide ? "wide" : "scalar"},
            {"instruction_set", instructionSetName(settings_.instructionSet)},
            {"hull", options_.hull == "embree" ? "embree" : hullName(*scene_)}};
  }

 private:
  std::shared_ptr<const FlatScene> scene_;
  RenderOptions options_;
  CpuTracerSettings settings_;
  Lanes lanes_;
  TileKernel kernel_;
  ThreadArena arena_;
  std::unique_ptr<HullQuery> hull_;
};

}  // namespace

std::unique_ptr<Renderer> makeCpuRenderer(std::shared_ptr<const FlatScene> scene,
                                          const RenderOptions& options,
                                          const CpuTracerSettings& settings) {
  return std::make_unique<CpuRenderer>(std::move(scene), options, settings);
}

}  // namespace twintrace
