#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/probe/answers.h"
#include "experiments/probe/shader_function.h"
#include "experiments/probe/ulp_histogram.h"

namespace twintrace::probe {

struct TrialSettings {
  std::size_t samples = 100000;  ///< random records per world, beyond the special ones
  std::uint64_t seed = 1;
  Maths maths = Maths::strict;  ///< of the shader; twins are strict
};

/// One record with all answers to it.
struct Record {
  std::string world;
  std::vector<std::uint32_t> inputs;
  std::vector<std::uint32_t> gpu;
  std::vector<std::uint32_t> twin;
  std::vector<double> twin64;     ///< empty where there is none
  std::vector<float> reference;   ///< correctly rounded; empty where there is none
};

/// How far the shader's answers are from those of another, per record the word that is farthest.
struct Distances {
  UlpHistogram ulps;
  std::optional<Record> worst;  ///< the first of the largest finite distance above 0
  std::uint32_t worstUlps = 0;  ///< finite; answers that no distance describes come first if alone
};

enum class Verdict { identical, differs, noTwin, notInNative };

/// What came out for one function.
struct FunctionTrial {
  const ShaderFunction* function = nullptr;
  Verdict verdict = Verdict::identical;
  std::size_t records = 0;
  std::size_t differing = 0;             ///< records in which shader and float twin differ
  Distances toTwin;
  std::optional<Distances> toTwin64;     ///< the double twin's answers rounded to float
  std::optional<Distances> toReference;  ///< over the records in the reference's domain
  double seconds = 0;
};

/// `identical`, `differs`, `no twin` or `not in native maths`.
const char* verdictName(Verdict verdict);

/// Functions by name or signature (white space is free); all if none is given.
/// @throws UsageError for a name that no function has, with the nearest one.
std::vector<const ShaderFunction*> chooseFunctions(const std::vector<std::string>& names);

/// Runs a function over special, random and boundary inputs in all worlds that it can tell apart,
/// then over inputs around the worst records found.
/// @throws DeviceError if the driver rejects the program.
FunctionTrial tryFunction(Context& context, const ShaderLibrary& library,
                          const ShaderFunction& function, const TrialSettings& settings);

/// All answers to one record of packed words in a world, with its options' maths.
Record replay(Context& context, const ShaderLibrary& library, const ShaderFunction& function,
              const World& world, const std::vector<std::uint32_t>& inputs);

/// Distance of two words of that kind in ulp, denormals taken as zero; 2^32 - 1 where integers or
/// truth values differ, or one is NaN.
std::uint32_t wordDistance(Kind kind, std::uint32_t a, std::uint32_t b);

/// Whether two answers to a record differ in strict maths' sense.
bool differ(const ShaderFunction& function, const std::vector<std::uint32_t>& a,
            const std::vector<std::uint32_t>& b);

/// The double as a word of that kind, rounded once.
std::uint32_t wordOf(Kind kind, double value);

}  // namespace twintrace::probe
