#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/scene/flat_scene.h"
#include "common/trace/call_trace.h"
#include "gpu/glsl_instrumenter.h"
#include "gpu/shader_source.h"

namespace twintrace {

class Context;

/// A shader function wrapped into a compute main that runs it over packed records of 32-bit words.
///
/// The main reads `probeInputs` (storage binding 0), writes `probeOutputs` (binding 1), leaves out
/// invocations from `probeCount` (uniform int) on and has a work group of kProbeGroupSize.
struct Probe {
  std::string main;  ///< GLSL text, without #version
  int inputWords;    ///< words of one record of inputs
  int outputWords;   ///< words of one record of outputs
};

inline constexpr int kProbeGroupSize = 64;

/// Runs the function once per record.
///
/// @param scene whose texels and constants the function reads.
/// @param options how the program is specialised; stage and provider have no meaning here.
/// @param inputs records of probe.inputWords each.
/// @return as many records of probe.outputWords each.
/// @throws DeviceError if the driver rejects the program or the device fails, UsageError if the
///   inputs are no whole number of records.
std::vector<std::uint32_t> runProbe(Context& context, const ShaderLibrary& library,
                                    const Probe& probe, const FlatScene& scene,
                                    const RenderOptions& options,
                                    std::span<const std::uint32_t> inputs);

/// What a probe did with one record.
struct ProbeTrace {
  TraceProgram program;
  CallTrace trace;
  std::vector<std::uint32_t> outputs;  ///< of the instrumented program
};

/// Runs the function once, with its calls and those inside recorded.
/// @param inputs one record.
/// @throws as runProbe; FileError for shaders that can't be parsed.
ProbeTrace traceProbe(Context& context, const ShaderLibrary& library, const Probe& probe,
                      const FlatScene& scene, const RenderOptions& options,
                      std::span<const std::uint32_t> inputs, const InstrumentSettings& settings);

}  // namespace twintrace
