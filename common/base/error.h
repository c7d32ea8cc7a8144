#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace twintrace {

/// A place in a text file; line and column count from 1, 0 means "the file as a whole".
struct SourceLocation {
  std::string path;
  int line = 0;
  int column = 0;

  /// `path:line:column`, without the parts that are 0.
  std::string toString() const;
};

/// One thing that is wrong in a file, as `path:line:column: found ..., expected ...`.
struct Diagnostic {
  SourceLocation location;
  std::string message;

  std::string toString() const { return location.toString() + ": " + message; }
};

/// Bad content of a scene, config or data file: all of a file's faults at once. Exit code 2.
class FileError : public std::runtime_error {
 public:
  explicit FileError(std::vector<Diagnostic> diagnostics);
  /// One fault of the file as a whole.
  FileError(const std::string& path, const std::string& message);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// A request that can't be met as it was put: options that exclude each other, a value out of its
/// range. Exit code 2.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A back end, provider or device feature that this machine lacks. Exit code 3.
class DeviceError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The main input file can't be read, or an output can't be written. Exit code 4.
class IoError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace twintrace
