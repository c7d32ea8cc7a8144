#pragma once

#include <memory>

#include "common/cast/case_set.h"
#include "common/trace/options.h"
#include "gpu/shader_source.h"

namespace twintrace {

/// The shaders as a case engine, `gpu`: all rays of a case set in one dispatch, or one per 2^20 of
/// them. Reads provider, stage, maths, intersector and threads of the options; the shaders come from
/// the library.
/// @throws DeviceError if there is no such provider, if the driver rejects the program, or if the
/// cases don't fit the device; UsageError for precision double, which shaders don't have.
std::unique_ptr<CaseEngine> makeGpuCaseEngine(const RenderOptions& options,
                                              const ShaderLibrary& library);

}  // namespace twintrace
