#include "experiments/probe/statement_replay.h"

#include "cpu/trace/entry.h"
#include "experiments/probe/twin_trace.h"

namespace twintrace::probe {
namespace {

void compare(StatementReplay& result) {
  result.gpuTree = buildCallTree(result.gpu.program, result.gpu.trace);
  result.twinTree = buildCallTree(result.twinProgram, result.twin);
  result.divergence = firstDivergence(result.gpuTree, result.twinTree);
}

}  // namespace

std::string StatementReplay::culprit() const {
  return divergence ? std::string(gpuTree.name(divergence->a)) : "";
}

void replayStatements(Context& context, const ShaderLibrary& library,
                      const ShaderFunction& function, const World& world,
                      const std::vector<std::uint32_t>& inputs, StatementReplay& result) {
  const Probe probe{function.main, inputWords(function), outputWords(function)};
  std::vector<std::uint32_t> outputs(static_cast<std::size_t>(probe.outputWords));
  result.twinProgram = tracedKernelProgram();
  result.twin =
      traceTwin(function.signature, world.scene, world.options, inputs.data(), outputs.data());
  const auto run = [&](const InstrumentSettings& settings) {
    result.gpu = traceProbe(context, library, probe, world.scene, world.options, inputs, settings);
    compare(result);
  };
  // Recording all statements of all functions takes the driver long to compile: first the calls
  // alone, which tell whose statements are wanted.
  InstrumentSettings settings;
  settings.statements = [](const GlslFunction&) { return false; };
  run(settings);
  if (!result.divergence) return;
  const std::string name = result.culprit();
  settings.statements = [&](const GlslFunction& called) { return called.name == name; };
  run(settings);
}

}  // namespace twintrace::probe
