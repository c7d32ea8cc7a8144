#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/trace/call_trace.h"
#include "gpu/buffers.h"
#include "gpu/glsl_instrumenter.h"
#include "gpu/program.h"

namespace twintrace {

class Context;

/// Name of the shader file, one of a request's virtual files, with which the main of an
/// instrumented program stores its events. The main calls `traceChoose()` first and `traceKeep()`
/// last, does the same in each invocation, and has a work group of kTraceGroupSize.
inline constexpr const char* kTraceRecordsPath = "trace_records.glsl";
inline constexpr std::uint32_t kTraceGroupSize = 64;

/// The most invocations of one dispatch, and so the most events that it keeps.
inline constexpr std::uint32_t kTraceBatch = 2048;

/// The text of kTraceRecordsPath.
std::string traceRecordsText();

/// Runs an instrumented program as often as it takes to collect all of its events.
class TraceRecords {
 public:
  /// @param program compiled from the shader; both have to outlive this.
  TraceRecords(Context& context, Program& program, const InstrumentedShader& shader);

  /// The events of the program with the uniforms and buffers that it has; `radiance` is left zero.
  /// @throws DeviceError if the device fails.
  CallTrace collect();

 private:
  void run(std::uint32_t firstEvent, std::uint32_t count);
  void append(CallTrace& trace, std::uint32_t count) const;

  Program& program_;
  const InstrumentedShader& shader_;
  std::size_t recordWords_;
  std::vector<std::uint32_t> words_;
  StorageBuffer storage_;
};

}  // namespace twintrace
