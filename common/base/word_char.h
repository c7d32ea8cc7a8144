#pragma once

namespace twintrace {

/// Whether the character may stand in a name of GLSL or C++: an ASCII letter, a digit, `_`.
constexpr bool isWordChar(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace twintrace
