#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/benchmark/measure.h"

namespace twintrace {

/// A ratio that the project promises for the scene `cornell`.
struct Ratio {
  std::string name;
  std::optional<double> wall;  ///< nothing if one of its arms could not run
  std::optional<double> cpu;   ///< the same by the process's CPU time
  double bound = 0;
  bool atMost = false;  ///< the bound is an upper one

  bool holds(double value) const { return atMost ? value <= bound : value >= bound; }
};

/// The promised ratios on one scene, for a processor with this instruction set: wide lanes promise
/// less with AVX2 than with AVX-512, and nothing with SSE2.
std::vector<Ratio> promisedRatios(const SceneTimes& times, InstructionSet best);

}  // namespace twintrace
