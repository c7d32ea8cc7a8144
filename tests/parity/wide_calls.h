#pragma once

#include <cstdint>
#include <span>

#include "common/scene/flat_scene.h"

namespace twintrace::parity {

/// A twin called with wide floats, built for one instruction set. Generated. Plain types only: this
/// is the border between code built for different instruction sets.
struct WideFunction {
  const char* signature;
  unsigned uniformParameters;  ///< bit i: parameter i is the same in all lanes, that of lane 0
  int inputWords;
  int outputWords;
  /// Runs count records, a multiple of the lanes, with denormals flushed.
  void (*run)(const FlatScene& scene, const RenderOptions& options, const std::uint32_t* in,
              std::uint32_t* out, std::size_t count);
};

/// All wide functions of an instruction set.
struct WideTable {
  int lanes;
  std::size_t count;
  const WideFunction* functions;
};

WideTable wideTable_sse2();
WideTable wideTable_avx2();
WideTable wideTable_avx512();

}  // namespace twintrace::parity
