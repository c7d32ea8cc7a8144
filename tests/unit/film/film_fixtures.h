#pragma once

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <string>
#include <vector>

#include "common/film/film.h"

namespace twintrace::test {

/// A directory of one test, removed with all it holds at the end.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::random_device random;
    path_ = std::filesystem::temp_directory_path() /
            ("twintrace-film-" + std::to_string(getpid()) + "-" + std::to_string(random()));
    std::filesystem::create_directory(path_);
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  bool empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

inline std::string bytesOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline void writeBytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The message of the exception of that type which `action` throws; empty if it throws none.
template <class Error, class Action>
std::string messageOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// A frame of positive values over many magnitudes, from a seed.
inline std::vector<float> randomFrame(int width, int height, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::lognormal_distribution<float> distribution(0.0f, 3.0f);
  std::vector<float> sums(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  for (float& value : sums) value = distribution(random);
  return sums;
}

}  // namespace twintrace::test
