#include "tests/audit/probe_check.h"

#include <stdexcept>

#include "gpu/provider.h"

namespace twintrace::test {
namespace {

// Beyond the special ones; a mistake in a formula needs few.
constexpr std::size_t kRandomInputs = 2000;

/// The function of the probe with that signature in that file, or nothing.
const probe::ShaderFunction* probed(const FunctionText& text) {
  for (const probe::ShaderFunction* function : probe::shaderFunctions()) {
    if (function->signature == text.signature && function->file == text.file) return function;
  }
  return nullptr;
}

}  // namespace

ProbeCheck::ProbeCheck() : context_(createContext(Provider::osmesa, 0)) {}

Finding ProbeCheck::find(const Damage& damage) {
  const ShaderLibrary library({},
                              {{damage.shader.shader, {damage.shader.text, damage.shader.file}}});
  Finding finding;
  for (const auto* functions : {&damage.functions, &damage.callers}) {
    for (const FunctionText& text : *functions) {
      const probe::ShaderFunction* function = probed(text);
      if (function == nullptr || function->twin == nullptr) continue;
      finding.answer = Answer::no;
      if (!differs(*function, library)) continue;
      requireSound(*function);
      return {Answer::yes, text.name};
    }
  }
  return finding;
}

bool ProbeCheck::differs(const probe::ShaderFunction& function,
                         const ShaderLibrary& library) const {
  probe::TrialSettings settings;
  settings.samples = kRandomInputs;
  const probe::FunctionTrial trial = probe::tryFunction(*context_, library, function, settings);
  return trial.verdict == probe::Verdict::differs;
}

void ProbeCheck::requireSound(const probe::ShaderFunction& function) {
  if (!sound_.insert(function.signature).second) return;
  if (differs(function, ShaderLibrary())) {
    throw std::logic_error(std::string(function.signature) + " differs without a fault");
  }
}

}  // namespace twintrace::test
