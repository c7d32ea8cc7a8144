#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "common/scene/scene.h"

namespace twintrace {

/// Says whether a file that a scene names can be read.
using FileCheck = std::function<bool(const std::filesystem::path&)>;

/// Whether a path names a file, directories and the like excluded; follows links, never throws.
bool isReadableFile(const std::filesystem::path& path);

/// Reads and checks a scene file.
/// @throws IoError if the file can't be read; FileError with everything that is wrong in it.
Scene readScene(const std::filesystem::path& path);

/// Reads and checks the text of a scene.
/// @param path of the file: for messages, the default name, and to resolve the file names in it.
/// @param check asked for each file that the scene names.
/// @throws FileError with everything that is wrong in it.
Scene parseScene(std::string_view text, const std::string& path,
                 const FileCheck& check = isReadableFile);

}  // namespace twintrace
