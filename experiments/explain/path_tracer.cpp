#include "experiments/explain/path_tracer.h"

#include "cpu/trace/path_trace.h"
#include "cpu/tracer.h"
#include "gpu/path_trace.h"

namespace twintrace {
namespace {

class CpuArm : public PathTracer {
 public:
  CpuArm(std::shared_ptr<const FlatScene> scene, const RenderOptions& options)
      : tracer_(std::move(scene), options) {}

  CallTrace trace(const PixelPosition& pixel, std::uint32_t sample) override {
    return tracer_.trace(pixel, sample);
  }
  const TraceProgram& program() const override { return tracer_.program(); }

 private:
  CpuPathTracer tracer_;
};

class GpuArm : public PathTracer {
 public:
  GpuArm(std::shared_ptr<const FlatScene> scene, const RenderOptions& options,
         const InstrumentSettings& settings)
      : tracer_(std::move(scene), options, settings) {}

  CallTrace trace(const PixelPosition& pixel, std::uint32_t sample) override {
    return tracer_.trace(pixel, sample);
  }
  const TraceProgram& program() const override { return tracer_.program(); }

 private:
  GpuPathTracer tracer_;
};

}  // namespace

std::unique_ptr<PathTracer> makePathTracer(std::shared_ptr<const FlatScene> scene,
                                           const RenderOptions& options, TraceDetail detail) {
  if (options.backend == BackEnd::cpu) return std::make_unique<CpuArm>(std::move(scene), options);
  InstrumentSettings settings;
  if (detail == TraceDetail::statements) {
    settings.statements = [](const GlslFunction&) { return true; };
  }
  return std::make_unique<GpuArm>(std::move(scene), options, settings);
}

std::string replayNote(const RenderOptions& options) {
  if (options.backend == BackEnd::gpu) {
    return options.stage == Stage::fragment ? "fragment is replayed as compute" : "";
  }
  return chosenLanes(options) == Lanes::wide ? "wide lanes are replayed as scalar" : "";
}

}  // namespace twintrace
