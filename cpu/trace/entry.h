#pragma once

#include <cstdint>

#include "common/trace/call_trace.h"
#include "cpu/kernel_entry.h"

namespace twintrace {

/// One sample of one pixel.
struct TraceJob {
  const FlatScene* scene = nullptr;
  const RenderOptions* options = nullptr;
  const HullQuery* hull = nullptr;  ///< null: test every primitive
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
};

/// Runs a sample in the instrumented copy of the kernel, in the options' precision and maths. Values
/// in double are recorded rounded to float.
CallTrace runTracedKernel(const TraceJob& job);

/// What the words mean.
TraceProgram tracedKernelProgram();

}  // namespace twintrace
