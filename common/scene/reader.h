#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/scene/file_check.h"
#include "common/scene/scene.h"

namespace twintrace {

/// Whether a path names a file, directories and the like excluded; follows links, never throws.
bool isReadableFile(const std::filesystem::path& path);

/// Reads and checks a scene file, and expands its meshes and generators.
/// @throws IoError if the file can't be read; FileError with everything that is wrong in it.
Scene readScene(const std::filesystem::path& path);

/// Reads and checks the text of a scene.
/// @param path of the file: for messages, the default name, and to resolve the file names in it.
/// @param check asked for each file that the scene names.
/// Meshes and generators stay as they are written: see expandShapes.
/// @throws FileError with everything that is wrong in it.
Scene parseScene(std::string_view text, const std::string& path,
                 const FileCheck& check = isReadableFile);

}  // namespace twintrace
