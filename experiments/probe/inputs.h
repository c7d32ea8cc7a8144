#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "experiments/probe/shader_function.h"
#include "experiments/probe/worlds.h"

namespace twintrace::probe {

/// How many records of special values drawInputs() puts before the random ones.
inline constexpr std::size_t kSpecialCount = 4096;

/// Records of inputs within the function's contract: special values first, then random ones.
std::vector<std::uint32_t> drawInputs(const ShaderFunction& function, const World& world,
                                      std::size_t randomCount, std::uint64_t seed);

/// @throws UsageError if an input says to read where the world has nothing.
void checkInputs(const ShaderFunction& function, const World& world,
                 std::span<const std::uint32_t> record);

/// Records around a given one: its real words moved by up to 64 ulp each, all others as they are.
std::vector<std::uint32_t> drawNear(const ShaderFunction& function,
                                    std::span<const std::uint32_t> record, std::size_t count,
                                    std::uint64_t seed);

/// For a function of one unrestricted float: where its pieces are likely to meet, each with its
/// neighbours: powers of two, multiples of an eighth turn, integers. For others nothing.
std::vector<std::uint32_t> boundaryInputs(const ShaderFunction& function);

}  // namespace twintrace::probe
