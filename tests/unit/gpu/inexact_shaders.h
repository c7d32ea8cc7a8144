#pragma once

#include <stdexcept>
#include <string>

#include "gpu/shader_source.h"

namespace twintrace {

/// The file of the shader library in which a device's own division and square root are taken.
inline constexpr const char* kCorrectedShader = "corrected.glsl";

inline std::string shaderText(const std::string& path) {
  return ShaderLibrary().find(path).value().text;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no " + from);
  return text.replace(at, from.size(), to);
}

/// Moves the result of the statement `precise float result = EXPRESSION;` by -2 .. 2 ulp, as its
/// operand decides.
inline std::string perturbed(const std::string& text, const std::string& expression,
                             const std::string& operand) {
  return replaced(text, "precise float result = " + expression + ";",
                  "precise float near = " + expression +
                      ";\n  uint draw = ((floatBitsToUint(" + operand +
                      ") * 2654435761u) >> 16) % 5u;\n"
                      "  uint bits = floatBitsToUint(near);\n"
                      "  uint size = bits & 0x7fffffffu;\n"
                      "  uint moved = select(size > 0x10000000u && size < 0x70000000u,\n"
                      "                      bits + draw - 2u, bits);\n"
                      "  precise float result = uintBitsToFloat(moved);");
}

/// corrected.glsl for a device whose division and square root are up to 2 ulp off.
inline std::string inexactArithmetic() {
  const std::string text = shaderText(kCorrectedShader);
  return perturbed(perturbed(text, "a / b", "b"), "sqrt(x)", "x");
}

/// The same with a correction that does nothing for division.
inline std::string withoutCorrection() {
  return replaced(inexactArithmetic(), "precise float result = refinedQuotient(a, b, guess);",
                  "precise float result = approximateQuotient(a, b);");
}

inline ShaderLibrary libraryWith(const std::string& correctedText) {
  return ShaderLibrary({}, {{kCorrectedShader, {correctedText, ""}}});
}

}  // namespace twintrace
