#include "common/base/error.h"

namespace twintrace {

std::string SourceLocation::toString() const {
  std::string text = path;
  if (line > 0) text.append(":").append(std::to_string(line));
  if (line > 0 && column > 0) text.append(":").append(std::to_string(column));
  return text;
}

namespace {

std::string joinLines(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += "\n";
    text += diagnostic.toString();
  }
  return text;
}

std::vector<Diagnostic> oneFault(const std::string& path, const std::string& message) {
  std::vector<Diagnostic> diagnostics(1);
  diagnostics[0].location.path = path;
  diagnostics[0].message = message;
  return diagnostics;
}

}  // namespace

FileError::FileError(const std::string& path, const std::string& message)
    : FileError(oneFault(path, message)) {}

FileError::FileError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joinLines(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace twintrace
