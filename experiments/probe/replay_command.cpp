#include "experiments/probe/replay_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "common/base/word_char.h"
#include "common/scene/option_names.h"
#include "experiments/probe/shader_function.h"

namespace twintrace::probe {
namespace {

/// A word for a POSIX shell.
std::string shellWord(const std::string& text) {
  const auto isPlain = [](char c) {
    return isWordChar(c) || std::string_view("-./=:,+").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, isPlain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

bool isKnown(const std::string& signature, std::size_t wordCount) {
  return std::ranges::any_of(shaderFunctions(), [&](const ShaderFunction* function) {
    std::size_t words = 0;
    for (const Slot& slot : function->inputs) words += static_cast<std::size_t>(slot.size);
    return function->signature == signature && words == wordCount && function->twin != nullptr;
  });
}

std::string optionsText(const RenderOptions& ofScene, const RenderOptions& options) {
  std::string text;
  const auto add = [&](const char* name, const RenderOptions& unsaid) {
    const Option& option = *findOption(name);
    const std::string value = option.get(options);
    // An integrator that is named implies an intersector, unless that is named too.
    const bool implied = std::string_view(name) == "intersector" &&
                         options.integrator != ofScene.integrator;
    if (implied || value != option.get(unsaid)) {
      text += fmt::format(" --{} {}", name, shellWord(value));
    }
  };
  for (const char* name : kSceneOptions) add(name, ofScene);
  add("maths", ofScene);
  add("gl", RenderOptions{});
  if (!options.shaderDirectory.empty()) {
    text += " --shader-dir " + shellWord(options.shaderDirectory);
  }
  for (const ShaderReplacement& replacement : options.shaderOverrides) {
    text += " --override " + shellWord("shaders/" + replacement.shader + "=" + replacement.file);
  }
  return text;
}

}  // namespace

std::string replayCommand(const Scene& scene, const RenderOptions& a, const RenderOptions& b,
                          const SampleExplanation& explanation) {
  const bool hasShader = a.backend == BackEnd::gpu || b.backend == BackEnd::gpu;
  if (!explanation.divergence || !hasShader) return "";
  const Call& call = explanation.treeA.calls[static_cast<std::size_t>(explanation.divergence->a)];
  const TraceFunction& function =
      explanation.treeA.program->functions[static_cast<std::size_t>(call.function)];
  const std::string signature = signatureOf(function);
  if (!isKnown(signature, call.inputs.words.size())) return "";
  const RenderOptions& options = b.backend == BackEnd::gpu ? b : a;
  return fmt::format("twintrace probe {} --inputs {} --statements --scene {}{}",
                     shellWord(signature),
                     shellWord(fmt::format("{:#010x}", fmt::join(call.inputs.words, ","))),
                     shellWord(scene.path), optionsText(scene.render, options));
}

}  // namespace twintrace::probe
