#pragma once

#include <memory>
#include <string>

#include "common/film/image.h"
#include "common/scene/flat_scene.h"
#include "common/trace/call_trace.h"

namespace twintrace {

/// One arm, able to show what it does in a sample.
class PathTracer {
 public:
  virtual ~PathTracer() = default;

  /// The calls of one sample of a pixel. @throws DeviceError if the device fails.
  virtual CallTrace trace(const PixelPosition& pixel, std::uint32_t sample) = 0;

  /// What the traces' words mean.
  virtual const TraceProgram& program() const = 0;
};

/// How much is recorded: calls alone, or each statement's value too.
enum class TraceDetail { calls, statements };

/// The tracer of the options' back end, precision and maths.
/// @throws DeviceError and FileError as GpuPathTracer.
std::unique_ptr<PathTracer> makePathTracer(std::shared_ptr<const FlatScene> scene,
                                           const RenderOptions& options, TraceDetail detail);

/// How the replay differs from the arm as it renders, in words; empty if it doesn't.
std::string replayNote(const RenderOptions& options);

}  // namespace twintrace
