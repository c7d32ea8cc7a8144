#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/probe/answers.h"
#include "experiments/probe/inputs.h"
#include "experiments/probe/shader_function.h"
#include "experiments/probe/worlds.h"
#include "tests/catch.h"
#include "tests/parity/witness.h"

namespace twintrace::parity {

using probe::drawInputs;
using probe::inputWords;
using probe::outputWords;
using probe::plainWorld;
using probe::runShader;
using probe::runTwin;
using probe::ShaderFunction;
using probe::shaderFunctions;
using probe::World;
using probe::worldsFor;

/// A function of the third witness, called with packed words. Generated.
using WitnessCall = void (*)(Witness& witness, const std::uint32_t* in, std::uint32_t* out);

/// The function of that signature; fails the test if there is none.
const ShaderFunction& functionOf(const std::string& signature);

/// The answers of the witness for each record. Denormals are flushed.
std::vector<std::uint32_t> runWitness(const ShaderFunction& function, WitnessCall call,
                                      const World& world, std::span<const std::uint32_t> inputs);

/// Records in which two answers differ. Floats: NaN equals NaN, the sign of zero is free.
struct Difference {
  std::size_t records = 0;  ///< in all
  std::size_t differing = 0;
  std::size_t first = 0;  ///< index of the first one that differs
  std::uint32_t maxUlp = 0;
};
Difference differenceOf(const ShaderFunction& function, std::span<const std::uint32_t> a,
                        std::span<const std::uint32_t> b);

/// What there is to say about a record: function, file, inputs and answers as hex floats.
/// @param answers pairs of who answered and all of the answers; ULP distances are to the first.
std::string describe(const ShaderFunction& function, const World& world, std::size_t record,
                     std::span<const std::uint32_t> inputs,
                     const std::vector<std::pair<std::string, std::span<const std::uint32_t>>>& answers);

inline constexpr std::size_t kRandomCount = 100000;
inline constexpr std::uint64_t kSeed = 20240229;

/// Fails the running test unless shader, twin and witness have the same bits in all worlds; under
/// all providers that this machine has in the plain world, under the first in the others.
void checkParity(const std::string& signature, WitnessCall call);

}  // namespace twintrace::parity
