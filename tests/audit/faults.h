#pragma once

#include <set>
#include <string>
#include <vector>

#include "gpu/shader_source.h"
#include "tests/unit/experiments/explain/explain_fixtures.h"

namespace twintrace::test {

/// A place in the shaders where a result can be moved by one ulp.
struct FaultPlace {
  std::string function;
  std::string file;
  std::string word;          ///< of the result, as in ".normal.x"; empty for a float
  ShaderReplacement shader;  ///< with the fault
  std::string place;         ///< `file:line` of the statement that is at fault
};

/// The faults of a function: one for each float in its result.
using FunctionFaults = std::vector<FaultPlace>;

/// One entry for each function of the library with one of the names and a float in its result. The
/// fault is in the last return; zeros, infinities and NaNs pass through it unharmed.
std::vector<FunctionFaults> possibleFaults(const std::set<std::string>& functions);

}  // namespace twintrace::test
