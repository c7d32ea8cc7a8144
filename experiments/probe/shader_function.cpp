#include "experiments/probe/shader_function.h"

#include <algorithm>

namespace twintrace::probe {
namespace {

int wordsOf(std::span<const Slot> slots) {
  int words = 0;
  for (const Slot& slot : slots) words += slot.size;
  return words;
}

}  // namespace

int inputWords(const ShaderFunction& function) { return std::max(wordsOf(function.inputs), 1); }

int outputWords(const ShaderFunction& function) { return wordsOf(function.outputs); }

std::vector<Kind> outputKinds(const ShaderFunction& function) {
  std::vector<Kind> kinds;
  for (const Slot& slot : function.outputs) {
    kinds.insert(kinds.end(), static_cast<std::size_t>(slot.size), slot.kind);
  }
  return kinds;
}

}  // namespace twintrace::probe
