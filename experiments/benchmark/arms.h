#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/trace/options.h"
#include "cpu/tracer.h"

namespace twintrace {

/// One way to render a scene whose speed is measured.
struct BenchmarkArm {
  std::string name;  ///< back end and what is special, as in gpu/strict/fragment
  RenderOptions options;
  InstructionSet instructionSet = bestInstructionSet();  ///< of the wide lanes
};

// The arms that ratios are made of.
inline constexpr std::string_view kStrictFragment = "gpu/strict/fragment";
inline constexpr std::string_view kNativeFragment = "gpu/native/fragment";
inline constexpr std::string_view kStrictCompute = "gpu/strict/compute";
inline constexpr std::string_view kNativeCompute = "gpu/native/compute";
inline constexpr std::string_view kBufferGeometry = "gpu/strict/buffer";
inline constexpr std::string_view kAllEffects = "gpu/strict/all-effects+buffer";
inline constexpr std::string_view kScalar = "cpu/scalar";

/// The name of the arm of wide lanes with this instruction set.
std::string wideArmName(InstructionSet set);

/// Every arm that this machine's processor can run, all with the options of `base` but their own.
std::vector<BenchmarkArm> benchmarkArms(const RenderOptions& base);

}  // namespace twintrace
