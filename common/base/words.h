#pragma once

namespace twintrace {

/// Whether a name or number of GLSL or C++ may contain the character: an ASCII letter, a digit, `_`.
constexpr bool isWordChar(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace twintrace
