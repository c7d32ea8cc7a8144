#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"
#include "common/scene/toml_plus_plus.h"

namespace twintrace {

/// Collects what is wrong with one TOML file, so that all of it is reported at once.
class Faults {
 public:
  explicit Faults(std::string path) : path_(std::move(path)) {}

  /// Notes `found ..., expected ...` at a place of the file.
  void add(const toml::source_position& at, const std::string& found, const std::string& expected);
  /// Notes a message that is already worded.
  void add(const toml::source_position& at, std::string message);

  /// Throws a FileError with all faults in the order of the file, if there are any.
  void throwIfAny();

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<Diagnostic> diagnostics_;
};

/// Bytes of the largest file: of the order of a million objects.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{64} << 20;

/// Parses TOML 1.0.
/// @param path for messages only.
/// @throws FileError for text that is not TOML or longer than kMaxTomlBytes, in the wording of all
/// other faults.
toml::table parseToml(std::string_view text, const std::string& path);

}  // namespace twintrace
