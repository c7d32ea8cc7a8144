#pragma once

#include <string_view>

namespace twintrace::probe {

/// C++ text that gives GLSL's types and functions in double, to be put before a shader's own text:
/// vec2-4, ivec2-4, uvec2-4 and the usual builtins. Swizzles are read as `v.swizzle<0, 1>()`.
/// Matrices, images and bool vectors are left out.
std::string_view userPrelude();

}  // namespace twintrace::probe
