#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/trace/options.h"
#include "tests/audit/fault_table.h"

namespace twintrace::test {

/// A function of the shaders as text.
struct FunctionText {
  std::string name;       ///< of an entry point: `main of` its file
  std::string signature;  ///< as in `shade(vec3, float)`
  std::string file;
  std::string text;                ///< without comments
  std::set<std::string> mentions;  ///< all names in it
};

/// The functions of the shader library, and which of them use which. Native maths is left out: it
/// has the names of math.glsl, and no strict program has it.
class ShaderTexts {
 public:
  ShaderTexts();

  const std::vector<FunctionText>& functions() const { return functions_; }

  /// The names of a function and of all that it calls, at any depth.
  std::set<std::string> reachableFrom(const std::string& name) const;

 private:
  std::vector<FunctionText> functions_;
  std::map<std::string, std::set<std::string>> calls_;  ///< by name, of all overloads
};

/// A shader with a fault.
struct Damage {
  ShaderReplacement shader;
  /// Those whose own text has the fault, or that use a constant which has it.
  std::vector<FunctionText> functions;
  /// Other functions of the same file whose results may change since they call one of these.
  std::vector<FunctionText> callers;

  bool damages(const std::string& function) const;
  /// Names of the damaged functions, for messages.
  std::string where() const;
};

/// Plants faults, each in a copy of its own.
/// @throws UsageError, with all that are wrong, unless the text of each stands in its shader
/// exactly once and the change is one of a function or of a constant that functions use.
std::vector<Damage> plantAll(const std::vector<LogicFault>& faults, const ShaderTexts& texts);

}  // namespace twintrace::test
