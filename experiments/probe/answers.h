#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "experiments/probe/shader_function.h"
#include "experiments/probe/worlds.h"
#include "gpu/context.h"
#include "gpu/shader_source.h"

namespace twintrace::probe {

/// The answers of the float twin for each record of inputs. Denormals are flushed.
std::vector<std::uint32_t> runTwin(const ShaderFunction& function, const World& world,
                                   std::span<const std::uint32_t> inputs);

/// The answers of the double twin; float inputs that are denormal are read as zero.
std::vector<double> runTwin64(const ShaderFunction& function, const World& world,
                              std::span<const std::uint32_t> inputs);

/// The answers of the shader. @throws DeviceError if the driver rejects the program.
std::vector<std::uint32_t> runShader(Context& context, const ShaderLibrary& library,
                                     const ShaderFunction& function, const World& world,
                                     std::span<const std::uint32_t> inputs);

}  // namespace twintrace::probe
