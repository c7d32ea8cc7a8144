#pragma once

#include <string_view>

namespace twintrace {

/// What a builtin of GLSL should be, and how far from it the language lets it be.
struct ExactBuiltin {
  std::string_view name;  ///< as in builtins()
  /// The exact value, rounded to double once. Inputs are taken as exact.
  double (*value)(float a, float b, float c);
  /// The specification's bound in ulp for these inputs; null = it gives none as a number.
  double (*allowedUlp)(float a, float b, float c);
  /// The bound in its own words (OpenGL Shading Language 4.60, section 4.7.1).
  std::string_view allowance;
};

/// The entry of a builtin. The name has to be one of builtins().
const ExactBuiltin& exactBuiltin(std::string_view name);

}  // namespace twintrace
