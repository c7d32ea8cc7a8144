#pragma once

#include <memory>

#include "common/film/image.h"
#include "common/scene/flat_scene.h"
#include "common/trace/call_trace.h"
#include "gpu/glsl_instrumenter.h"

namespace twintrace {

/// Runs single samples of the GLSL tracer and records the calls of its functions. The program is a
/// compute shader of one invocation, whatever the options' stage, and reads its geometry from the
/// texel array; in strict maths both give the same bits.
class GpuPathTracer {
 public:
  /// @throws DeviceError as makeGpuRenderer; FileError for shaders that can't be parsed.
  GpuPathTracer(std::shared_ptr<const FlatScene> scene, const RenderOptions& options,
                const InstrumentSettings& settings);
  ~GpuPathTracer();

  /// The calls of one sample of a pixel of the film.
  /// @throws DeviceError if the device fails.
  CallTrace trace(const PixelPosition& pixel, std::uint32_t sample);

  /// What the traces' words mean.
  const TraceProgram& program() const;

 private:
  class Device;
  std::unique_ptr<Device> device_;
};

}  // namespace twintrace
