#include "common/nff/nff_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/nff/nff_reader.h"

namespace twintrace {
namespace {

/// Bytes of the largest file: 1e7 primitives of 200 bytes.
constexpr std::uintmax_t kMaxBytes = 2'000'000'000;

/// Only regular files have a size; a device may never end.
std::string readText(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw IoError("can't read " + path);
  if (size > kMaxBytes) {
    throw FileError(path, "found a larger file, expected at most 2e9 bytes");
  }
  std::string text(size, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.is_open() || file.bad()) throw IoError("can't read " + path);
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

}  // namespace

bool isNffName(std::string_view path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return ending == ".nff";
}

NffFile readNff(const std::string& path) {
  return parseNff(readText(path), path);
}

NffFile parseNff(std::string_view text, const std::string& path) {
  return NffReader(text, path).read();
}

}  // namespace twintrace
