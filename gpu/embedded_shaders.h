#pragma once

#include <span>
#include <string_view>

namespace twintrace {

/// One file of shaders/, compiled into the binary so that it runs from any directory.
struct EmbeddedShader {
  std::string_view path;  ///< relative to shaders/, as in `#include`
  std::string_view text;
};

/// All .glsl files that shaders/ held at build time, sorted by path.
std::span<const EmbeddedShader> embeddedShaders();

}  // namespace twintrace
