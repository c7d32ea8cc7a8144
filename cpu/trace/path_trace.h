#pragma once

#include <memory>

#include "common/film/image.h"
#include "common/scene/flat_scene.h"
#include "common/trace/call_trace.h"
#include "cpu/hull_query.h"

namespace twintrace {

/// Runs single samples of the CPU tracer and records the calls of its functions. Rays are carried one
/// at a time, also where the options ask for wide lanes; both give the same bits.
class CpuPathTracer {
 public:
  CpuPathTracer(std::shared_ptr<const FlatScene> scene, const RenderOptions& options);

  /// The calls of one sample of a pixel of the film.
  CallTrace trace(const PixelPosition& pixel, std::uint32_t sample) const;

  /// What the traces' words mean.
  const TraceProgram& program() const { return program_; }

 private:
  std::shared_ptr<const FlatScene> scene_;
  RenderOptions options_;
  std::unique_ptr<HullQuery> hull_;
  TraceProgram program_;
};

}  // namespace twintrace
