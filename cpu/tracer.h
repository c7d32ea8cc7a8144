#pragma once

#include <memory>

#include "common/scene/flat_scene.h"
#include "common/trace/renderer.h"

namespace twintrace {

/// Instruction sets that the wide kernel is built for, in order of width.
enum class InstructionSet { sse2, avx2, avx512 };

/// The widest instruction set that this processor and system support.
InstructionSet bestInstructionSet();

const char* instructionSetName(InstructionSet set);
int laneCount(InstructionSet set);

/// How the CPU tracer runs; none of it changes a bit of the result.
struct CpuTracerSettings {
  InstructionSet instructionSet = bestInstructionSet();
  int tileSize = 32;  ///< pixels
};

/// The lanes that `options` get: wide lanes exist for strict maths in float precision.
/// @throws UsageError if wide lanes were asked for and there are none.
Lanes chosenLanes(const RenderOptions& options);

/// The multithreaded C++ tracer of one scene.
/// @throws UsageError if the options exclude each other.
std::unique_ptr<Renderer> makeCpuRenderer(std::shared_ptr<const FlatScene> scene,
                                          const RenderOptions& options,
                                          const CpuTracerSettings& settings = {});

}  // namespace twintrace
