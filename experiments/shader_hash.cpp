#include "experiments/shader_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "common/base/error.h"

namespace twintrace {
namespace {

namespace fs = std::filesystem;

std::string readText(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw IoError(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Texts by name, since directories list their files in any order.
std::map<std::string, std::string> shaderTexts(const fs::path& directory) {
  std::map<std::string, std::string> texts;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(directory)) {
      if (!entry.is_regular_file() || entry.path().extension() != ".glsl") continue;
      texts[entry.path().lexically_relative(directory).generic_string()] = readText(entry.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw IoError(directory.string() + ": cannot be read: " + error.code().message());
  }
  return texts;
}

}  // namespace

std::string shaderDirectoryHash(const std::string& directory) {
  std::string all;
  for (const auto& [name, text] : shaderTexts(directory)) {
    all += fmt::format("{}:{}:{}:{}", name.size(), name, text.size(), text);
  }
  return shaderTextHash(all);
}

std::string shaderTextHash(const std::string& text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace twintrace
