#pragma once

#include <cstdint>
#include <string_view>

#include "common/scene/flat_scene.h"
#include "common/trace/call_trace.h"

namespace twintrace::probe {

/// Runs the float twin of a shader function once, with its calls and those inside recorded; what
/// the words mean is told by tracedKernelProgram(). Denormals are flushed.
/// @param signature of a function that has a twin, as in `dot3(vec3, vec3)`.
/// @param inputs the packed words of one record.
/// @param outputs has room for those of the result.
CallTrace traceTwin(std::string_view signature, const FlatScene& scene,
                    const RenderOptions& options, const std::uint32_t* inputs,
                    std::uint32_t* outputs);

}  // namespace twintrace::probe
