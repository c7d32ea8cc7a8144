#include "tests/parity/parity.h"

#include <algorithm>
#include <bit>
#include <cstdio>

#include "common/base/error.h"
#include "common/base/float_bits.h"
#include "gpu/provider.h"

namespace twintrace::parity {
namespace {

using probe::Kind;
using probe::Slot;

// Denormals are zero in strict maths; where one is only passed on, whether it is flushed depends on
// the instruction: a minimum flushes, a selection does not.
float flushed(std::uint32_t word) {
  return (word & 0x7f800000u) == 0u ? 0.0f : std::bit_cast<float>(word);
}

std::uint32_t wordDistance(bool real, std::uint32_t a, std::uint32_t b) {
  if (real) return ulpDistance(flushed(a), flushed(b));
  return a == b ? 0u : 0xffffffffu;
}

std::string wordText(Kind kind, std::uint32_t word) {
  char text[64];
  switch (kind) {
    case Kind::real: {
      const auto value = std::bit_cast<float>(word);
      std::snprintf(text, sizeof text, "%a (%.9g)", static_cast<double>(value),
                    static_cast<double>(value));
      break;
    }
    case Kind::integer:
      std::snprintf(text, sizeof text, "%d", static_cast<std::int32_t>(word));
      break;
    case Kind::natural:
      std::snprintf(text, sizeof text, "0x%08x", word);
      break;
    case Kind::truth:
      std::snprintf(text, sizeof text, "%s", (word & 1u) != 0u ? "true" : "false");
      break;
  }
  return text;
}

std::string slotsText(std::span<const Slot> slots, const std::uint32_t* words,
                      const std::uint32_t* reference) {
  std::string text;
  for (const Slot& slot : slots) {
    text.append("    ").append(slot.path).append(" =");
    for (int i = 0; i < slot.size; ++i, ++words) {
      text.append(" ").append(wordText(slot.kind, *words));
      if (reference == nullptr) continue;
      const std::uint32_t ulp = wordDistance(slot.kind == Kind::real, *reference++, *words);
      if (ulp != 0) text.append(" [").append(std::to_string(ulp)).append(" ulp off]");
    }
    text += "\n";
  }
  return text;
}

/// Whose fault it is, by which of the others the witness sides with.
std::string diagnosis(bool witnessIsTwin, bool witnessIsShader) {
  if (witnessIsTwin) return "the witness agrees with the twin: the arithmetic of the GL differs";
  if (witnessIsShader) return "the witness agrees with the shader: the twin's logic differs";
  return "the witness agrees with neither";
}

/// The answers of both CPU implementations in one world.
struct Expected {
  std::vector<std::uint32_t> inputs, twin, witness;
};

Expected expectedIn(const ShaderFunction& function, WitnessCall call, const World& world) {
  Expected expected;
  expected.inputs = drawInputs(function, world, kRandomCount, kSeed);
  expected.witness = runWitness(function, call, world, expected.inputs);
  expected.twin = function.twin != nullptr ? runTwin(function, world, expected.inputs)
                                           : expected.witness;
  return expected;
}

void checkShader(Context& context, const ShaderFunction& function, const World& world,
                 const Expected& expected) {
  const auto shader = runShader(context, ShaderLibrary(), function, world, expected.inputs);
  const Difference found = differenceOf(function, expected.twin, shader);
  if (found.differing == 0) return;
  const auto stride = static_cast<std::size_t>(outputWords(function));
  const auto recordOf = [&](const std::vector<std::uint32_t>& all) {
    return std::span(all).subspan(found.first * stride, stride);
  };
  const auto witness = recordOf(expected.witness);
  const bool isTwin = differenceOf(function, witness, recordOf(expected.twin)).differing == 0;
  const bool isShader = differenceOf(function, witness, recordOf(shader)).differing == 0;
  FAIL_CHECK(context.source() << ": " << found.differing << " of " << found.records
             << " records differ, at most " << found.maxUlp << " ulp; " << diagnosis(isTwin, isShader)
             << "\n" << describe(function, world, found.first, expected.inputs,
                         {{"twin", expected.twin}, {"witness", expected.witness}, {"shader", shader}}));
}

}  // namespace

const ShaderFunction& functionOf(const std::string& signature) {
  for (const ShaderFunction* function : shaderFunctions()) {
    if (function->signature == signature) return *function;
  }
  FAIL("no shader function " << signature);
  throw UsageError("no shader function " + signature);
}

Difference differenceOf(const ShaderFunction& function, std::span<const std::uint32_t> a,
                        std::span<const std::uint32_t> b) {
  const auto stride = static_cast<std::size_t>(outputWords(function));
  const std::vector<Kind> kinds = outputKinds(function);
  Difference found;
  found.records = a.size() / stride;
  for (std::size_t record = 0; record < found.records; ++record) {
    std::uint32_t ulp = 0;
    for (std::size_t word = 0; word < stride; ++word) {
      const std::size_t at = record * stride + word;
      ulp = std::max(ulp, wordDistance(kinds[word] == Kind::real, a[at], b[at]));
    }
    if (ulp == 0) continue;
    if (found.differing++ == 0) found.first = record;
    found.maxUlp = std::max(found.maxUlp, ulp);
  }
  return found;
}

std::string describe(
    const ShaderFunction& function, const World& world, std::size_t record,
    std::span<const std::uint32_t> inputs,
    const std::vector<std::pair<std::string, std::span<const std::uint32_t>>>& answers) {
  const auto in = static_cast<std::size_t>(inputWords(function));
  const auto out = static_cast<std::size_t>(outputWords(function));
  std::string text = std::string(function.signature) + " of shaders/" + function.file + ", world " +
                     world.name + ", record " + std::to_string(record) + ", seed " +
                     std::to_string(kSeed) + "\n  inputs\n" +
                     slotsText(function.inputs, &inputs[record * in], nullptr);
  const std::uint32_t* reference = &answers.front().second[record * out];
  for (const auto& [who, words] : answers) {
    text += "  " + who + "\n" + slotsText(function.outputs, &words[record * out], reference);
  }
  return text;
}

void checkParity(const std::string& signature, WitnessCall call) {
  const ShaderFunction& function = functionOf(signature);
  std::vector<std::unique_ptr<Context>> contexts;
  for (const Provider provider : {Provider::osmesa, Provider::egl}) {
    try {
      contexts.push_back(createContext(provider, 0));
    } catch (const DeviceError& error) {
      WARN("left out: " << error.what());
    }
  }
  for (const World& world : worldsFor(function)) {
    const Expected expected = expectedIn(function, call, world);
    const Difference found = differenceOf(function, expected.twin, expected.witness);
    if (found.differing != 0) {
      FAIL_CHECK("twin and witness differ in "
                 << found.differing << " of " << found.records << " records, at most "
                 << found.maxUlp << " ulp\n"
                 << describe(function, world, found.first, expected.inputs,
                             {{"twin", expected.twin}, {"witness", expected.witness}}));
    }
    for (const auto& context : contexts) checkShader(*context, function, world, expected);
    contexts.resize(std::min<std::size_t>(contexts.size(), 1));
  }
  SUCCEED("no difference");
}

}  // namespace twintrace::parity
