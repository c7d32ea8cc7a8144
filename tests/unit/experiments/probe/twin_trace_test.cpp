#include "experiments/probe/twin_trace.h"

#include "cpu/trace/entry.h"
#include "experiments/probe/answers.h"
#include "experiments/probe/inputs.h"
#include "experiments/probe/trial.h"
#include "tests/catch.h"

namespace twintrace::probe {
namespace {

/// The inputs and results that a trace tells for the call of a function with that very signature, by
/// which explain hands it on to probe; empty if it has none.
std::vector<std::uint32_t> toldWords(const ShaderFunction& function, const TraceProgram& program,
                                     const CallTrace& trace) {
  std::vector<std::uint32_t> told;
  const auto add = [&](std::size_t site, std::size_t at) {
    const auto begin = trace.words.begin() + static_cast<std::ptrdiff_t>(at);
    told.insert(told.end(), begin,
                begin + static_cast<std::ptrdiff_t>(program.sites[site].slots.size()));
  };
  std::size_t last = 0;
  for (std::size_t at = 0; at < trace.words.size();
       at += 1 + program.sites[trace.words[at]].slots.size()) {
    last = at;
  }
  const std::size_t first = trace.words.empty() ? 0 : trace.words[0];
  const auto& called = program.functions[static_cast<std::size_t>(program.sites[first].function)];
  if (trace.words.empty() || signatureOf(called) != function.signature) return {};
  add(first, 1);
  add(trace.words[last], last + 1);
  return told;
}

}  // namespace

TEST_CASE("traceTwin answers as the twin does, for every function", "[unit]") {
  const World world = plainWorld();
  const TraceProgram program = tracedKernelProgram();
  for (const ShaderFunction* function : shaderFunctions()) {
    if (function->twin == nullptr) continue;
    INFO(function->signature);
    const auto in = static_cast<std::size_t>(inputWords(*function));
    auto inputs = drawInputs(*function, world, 1, 7);
    inputs.erase(inputs.begin(), inputs.end() - static_cast<std::ptrdiff_t>(in));
    const std::vector<std::uint32_t> expected = runTwin(*function, world, inputs);
    std::vector<std::uint32_t> outputs(expected.size());
    const CallTrace trace =
        traceTwin(function->signature, world.scene, world.options, inputs.data(), outputs.data());
    CHECK_FALSE(differ(*function, outputs, expected));
    // The loop over samples is not traced itself.
    if (std::string_view(function->name) == "renderPixel") continue;
    const std::vector<std::uint32_t> told = toldWords(*function, program, trace);
    REQUIRE(told.size() >= outputs.size());
    CHECK(std::equal(outputs.begin(), outputs.end(),
                     told.end() - static_cast<std::ptrdiff_t>(outputs.size())));
    if (!function->inputs.empty()) CHECK(std::equal(inputs.begin(), inputs.end(), told.begin()));
  }
}

}  // namespace twintrace::probe
