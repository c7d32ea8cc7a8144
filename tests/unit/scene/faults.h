#pragma once

#include <string>
#include <string_view>

#include "common/base/error.h"
#include "common/scene/reader.h"

namespace twintrace {

/// A valid material and object to build faulty files on; three lines.
inline constexpr std::string_view kWhite = "[materials.white]\nalbedo = [0.7, 0.7, 0.7]\n\n";

/// All messages of the file s.toml, one per line, or "" if there are none. Every file that the
/// text names counts as there.
inline std::string faultsOf(std::string_view text) {
  try {
    parseScene(text, "s.toml", [](const std::filesystem::path&) { return true; });
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

}  // namespace twintrace
