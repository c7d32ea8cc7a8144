#include "common/film/atomic_file.h"

#include <filesystem>
#include <random>

#include "common/base/error.h"

namespace twintrace {
namespace {

std::string withoutLinks(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  return error ? path : target.string();
}

std::string partialName(const std::filesystem::path& path) {
  std::random_device random;
  std::string name = ".";
  name += path.stem().string() + "." + std::to_string(random()) + ".partial";
  name += path.extension().string();
  return (path.parent_path() / name).string();
}

}  // namespace

bool isDevice(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_other(path, error);
}

AtomicFile::AtomicFile(const std::string& path)
    : path_(withoutLinks(path)), direct_(isDevice(path_)), partialPath_(partialName(path_)) {}

AtomicFile::~AtomicFile() {
  if (direct_) return;
  std::error_code ignored;
  std::filesystem::remove(partialPath_, ignored);
}

void AtomicFile::commit() {
  if (direct_) return;
  std::error_code error;
  std::filesystem::rename(partialPath_, path_, error);
  if (error) throw IoError(path_ + ": cannot be written: " + error.message());
}

}  // namespace twintrace
