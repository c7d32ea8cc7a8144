#pragma once

#include <string>

namespace twintrace {

/// Hash of names and texts of all shader files (.glsl) below a directory, as 32 hexadecimal digits.
/// @throws IoError if one can't be read.
std::string shaderDirectoryHash(const std::string& directory);

/// Hash of a shader's text, as 32 hexadecimal digits.
std::string shaderTextHash(const std::string& text);

}  // namespace twintrace
