#pragma once

#include <string>

#include "common/trace/options.h"

namespace twintrace {

/// Reads a user's file that replaces one of the shader library.
/// @param assignment `shaders/X.glsl=FILE`; the leading `shaders/` may be left out.
/// @param shaderDirectory where the library is read; empty = the shaders in the binary.
/// @throws UsageError for a text of another form, a shader that the library doesn't have (with the
/// nearest name), and a file that can't be read.
ShaderReplacement readShaderOverride(const std::string& assignment,
                                     const std::string& shaderDirectory);

}  // namespace twintrace
