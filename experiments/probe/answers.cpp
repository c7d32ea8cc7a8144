#include "experiments/probe/answers.h"

#include "common/base/flush_denormals.h"
#include "gpu/probe.h"

namespace twintrace::probe {
namespace {

template <class Word>
std::vector<Word> callForEach(void (*call)(const kernel::SceneView&, const std::uint32_t*, Word*),
                              const ShaderFunction& function, const World& world,
                              std::span<const std::uint32_t> inputs) {
  const FlushDenormals flush;
  const auto in = static_cast<std::size_t>(inputWords(function));
  const auto out = static_cast<std::size_t>(outputWords(function));
  std::vector<Word> results(inputs.size() / in * out);
  for (std::size_t i = 0; i * in < inputs.size(); ++i) {
    call(world.view, &inputs[i * in], &results[i * out]);
  }
  return results;
}

}  // namespace

std::vector<std::uint32_t> runTwin(const ShaderFunction& function, const World& world,
                                   std::span<const std::uint32_t> inputs) {
  return callForEach(function.twin, function, world, inputs);
}

std::vector<double> runTwin64(const ShaderFunction& function, const World& world,
                              std::span<const std::uint32_t> inputs) {
  return callForEach(function.twin64, function, world, inputs);
}

std::vector<std::uint32_t> runShader(Context& context, const ShaderLibrary& library,
                                     const ShaderFunction& function, const World& world,
                                     std::span<const std::uint32_t> inputs) {
  const Probe probe{function.main, inputWords(function), outputWords(function)};
  return runProbe(context, library, probe, world.scene, world.options, inputs);
}

}  // namespace twintrace::probe
