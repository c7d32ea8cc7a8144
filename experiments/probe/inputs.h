#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/probe/shader_function.h"
#include "experiments/probe/worlds.h"

namespace twintrace::probe {

/// How many records of special values drawInputs() puts before the random ones.
inline constexpr std::size_t kSpecialCount = 4096;

/// Records of inputs within the function's contract: special values first, then random ones.
std::vector<std::uint32_t> drawInputs(const ShaderFunction& function, const World& world,
                                      std::size_t randomCount, std::uint64_t seed);

}  // namespace twintrace::probe
