#include "common/film/atomic_file.h"

#include <filesystem>
#include <random>

#include "common/base/error.h"

namespace twintrace {
namespace {

std::string partialName(const std::filesystem::path& path) {
  std::random_device random;
  std::string name = ".";
  name += path.stem().string() + "." + std::to_string(random()) + ".partial";
  name += path.extension().string();
  return (path.parent_path() / name).string();
}

}  // namespace

AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)), partialPath_(partialName(path_)) {}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  std::filesystem::remove(partialPath_, ignored);
}

void AtomicFile::commit() {
  std::error_code error;
  std::filesystem::rename(partialPath_, path_, error);
  if (error) throw IoError(path_ + ": cannot be written: " + error.message());
}

}  // namespace twintrace
