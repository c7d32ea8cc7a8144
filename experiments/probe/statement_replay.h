#pragma once

#include <optional>
#include <vector>

#include "experiments/explain/divergence.h"
#include "experiments/probe/shader_function.h"
#include "experiments/probe/worlds.h"
#include "gpu/context.h"
#include "gpu/probe.h"

namespace twintrace::probe {

/// One record, run by the shader and by the float twin with every statement recorded. The trees are
/// views: it can't be copied.
struct StatementReplay {
  StatementReplay() = default;
  StatementReplay(const StatementReplay&) = delete;
  StatementReplay& operator=(const StatementReplay&) = delete;

  ProbeTrace gpu;
  TraceProgram twinProgram;
  CallTrace twin;
  CallTree gpuTree;
  CallTree twinTree;
  /// The innermost call with equal inputs and different outputs, with the first statement in it
  /// whose value differs; a is the shader. Nothing if all that was recorded agrees.
  std::optional<Divergence> divergence;

  /// The function that has the statement: the one that was run, or one that it calls.
  std::string culprit() const;
};

/// Runs a record into `result`, which must be fresh.
/// @param function one with a twin.
/// @param inputs the packed words of one record, within the world's bounds: see checkInputs().
/// @throws DeviceError if the driver rejects the program; FileError for shaders that can't be
///   parsed.
void replayStatements(Context& context, const ShaderLibrary& library,
                      const ShaderFunction& function, const World& world,
                      const std::vector<std::uint32_t>& inputs, StatementReplay& result);

}  // namespace twintrace::probe
