#include "common/scene/toml_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace twintrace {

namespace {

/// Dots in one line. toml++ frees dotted keys recursively, and about 1e5 levels exhaust the stack;
/// a table's path spans at most two lines.
constexpr std::ptrdiff_t kMaxDots = 4096;

toml::source_position positionOf(std::size_t line, std::size_t column) {
  return {static_cast<toml::source_index>(line), static_cast<toml::source_index>(column)};
}

void checkSize(std::string_view text, Faults& faults) {
  if (text.size() > kMaxTomlBytes) {
    faults.add(positionOf(0, 0), "a larger file", fmt::format("at most {} bytes", kMaxTomlBytes));
  }
  faults.throwIfAny();
}

void checkDepth(std::string_view text, Faults& faults) {
  std::size_t line = 1;
  while (true) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const std::string_view content = text.substr(0, length);
    const auto dots = std::count(content.begin(), content.end(), '.');
    if (dots > kMaxDots) {
      faults.add(positionOf(line, 1), fmt::format("{} dots in one line", dots),
                 fmt::format("at most {}", kMaxDots));
    }
    if (length == text.size()) break;
    text.remove_prefix(length + 1);
    ++line;
  }
  faults.throwIfAny();
}

/// toml++'s description split at its marks, or empty where a mark is missing.
struct Syntax {
  std::string context;  ///< what was being parsed
  std::string message;
};

Syntax splitContext(const std::string& description) {
  const std::string prefix = "Error while parsing ";
  const std::size_t colon = description.find(": ");
  if (!description.starts_with(prefix) || colon == std::string::npos) {
    return {"the text", description};
  }
  return {"the " + description.substr(prefix.size(), colon - prefix.size()),
          description.substr(colon + 2)};
}

std::string firstQuoted(const std::string& text) {
  const std::size_t open = text.find('\'');
  const std::size_t close = text.find('\'', open + 1);
  return close == std::string::npos ? text : text.substr(open, close - open + 1);
}

/// toml++'s wording of a syntax error in ours.
std::string wordSyntaxFault(const std::string& description) {
  const auto [context, message] = splitContext(description);
  const std::size_t saw = message.rfind(", saw ");
  if (message.starts_with("expected ") && saw != std::string::npos) {
    return fmt::format("found {} in {}, {}", message.substr(saw + 6), context,
                       message.substr(0, saw));
  }
  if (message.starts_with("encountered end-of-file")) {
    return "found the end of the file, expected the rest of " + context;
  }
  if (message.starts_with("cannot redefine existing")) {
    return fmt::format("found {} a second time, expected each key and table once",
                       firstQuoted(message));
  }
  if (message.ends_with("could not be interpreted as a value") ||
      message.ends_with("is not representable in 64 bits")) {
    return fmt::format("found {}, expected a number that fits in 64 bits", firstQuoted(message));
  }
  return fmt::format("found a fault in {} ({}), expected TOML 1.0", context, message);
}

auto orderInFile(const Diagnostic& diagnostic) {
  return std::tie(diagnostic.location.line, diagnostic.location.column);
}

}  // namespace

void Faults::add(const toml::source_position& at, const std::string& found,
                 const std::string& expected) {
  add(at, "found " + found + ", expected " + expected);
}

void Faults::add(const toml::source_position& at, std::string message) {
  const SourceLocation location{path_, static_cast<int>(at.line), static_cast<int>(at.column)};
  diagnostics_.push_back({location, std::move(message)});
}

void Faults::throwIfAny() {
  if (diagnostics_.empty()) return;
  std::stable_sort(
      diagnostics_.begin(), diagnostics_.end(),
      [](const Diagnostic& a, const Diagnostic& b) { return orderInFile(a) < orderInFile(b); });
  throw FileError(std::move(diagnostics_));
}

toml::table parseToml(std::string_view text, const std::string& path) {
  Faults faults(path);
  checkSize(text, faults);
  checkDepth(text, faults);
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    faults.add(error.source().begin, wordSyntaxFault(std::string(error.description())));
  }
  faults.throwIfAny();
  return {};
}

}  // namespace twintrace
