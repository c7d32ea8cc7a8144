#include "gpu/shader_source.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "gpu/embedded_shaders.h"

namespace twintrace {

namespace {

constexpr std::string_view kRootPrefix = "shaders/";
constexpr std::string_view kBlanks = " \t";

std::string withoutRoot(const std::string& path) {
  return path.starts_with(kRootPrefix) ? path.substr(kRootPrefix.size()) : path;
}

bool isIdentifierChar(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Replaces the token by blanks, so that columns stay as they are.
std::string blankOut(std::string text, std::string_view token) {
  for (std::size_t at = text.find(token); at != std::string::npos; at = text.find(token, at + 1)) {
    const std::size_t end = at + token.size();
    const bool startsToken = at == 0 || !isIdentifierChar(text[at - 1]);
    const bool endsToken = end == text.size() || !isIdentifierChar(text[end]);
    if (startsToken && endsToken) text.replace(at, token.size(), token.size(), ' ');
  }
  return text;
}

std::string_view skipBlanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(kBlanks), text.size()));
}

/// What follows `# name` on a line, or nothing if the line is something else.
std::optional<std::string_view> afterDirective(std::string_view line, std::string_view name) {
  std::string_view rest = skipBlanks(line);
  if (!rest.starts_with('#')) return std::nullopt;
  rest = skipBlanks(rest.substr(1));
  if (!rest.starts_with(name)) return std::nullopt;
  rest.remove_prefix(name.size());
  if (!rest.empty() && isIdentifierChar(rest.front())) return std::nullopt;
  return skipBlanks(rest);
}

bool isPragmaOnce(std::string_view line) {
  const auto pragma = afterDirective(line, "pragma");
  if (!pragma || !pragma->starts_with("once")) return false;
  const std::string_view rest = skipBlanks(pragma->substr(4));
  return rest.empty() || rest.starts_with("//");
}

/// The text between the double quotes that a string begins with, or nothing.
std::optional<std::string> quoted(std::string_view text) {
  if (!text.starts_with('"')) return std::nullopt;
  const std::size_t end = text.find('"', 1);
  if (end == std::string_view::npos) return std::nullopt;
  return std::string(text.substr(1, end - 1));
}

std::vector<std::string_view> splitLines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

/// The place that a line of a driver's log begins with; line 0 where there is none.
struct LogPlace {
  int line = 0;
  int column = 0;
  int length = 0;  ///< characters of the log that name it
};

LogPlace parseLogPlace(const char* text) {
  LogPlace mesa;
  const int mesaFields =
      std::sscanf(text, "0:%9d(%9d): %n", &mesa.line, &mesa.column, &mesa.length);
  if (mesaFields == 2 && mesa.length > 0) return mesa;
  LogPlace nvidia;
  const int nvidiaFields = std::sscanf(text, "0(%9d) : %n", &nvidia.line, &nvidia.length);
  if (nvidiaFields == 1 && nvidia.length > 0) return nvidia;
  return {};
}

/// Builds one text out of a main file and all that it includes.
class Assembler {
 public:
  Assembler(const ShaderLibrary& library, const ShaderRequest& request)
      : library_(library), request_(request) {}

  ShaderSource assemble();

 private:
  void appendFile(const std::string& path, const ShaderFile& file);
  void include(std::string_view argument, const SourceLocation& location);
  std::string resolve(const std::string& path) const;
  std::optional<ShaderFile> find(const std::string& path) const;
  std::size_t fileNumber(const std::string& displayName);
  void addLine(std::string_view line, ShaderSource::Line place);
  void complain(const SourceLocation& location, const std::string& message);

  const ShaderLibrary& library_;
  const ShaderRequest& request_;
  ShaderSource source_;
  std::set<std::string> once_;
  std::vector<std::string> open_;  // paths of the files being included, outermost first
  std::vector<Diagnostic> diagnostics_;
};

ShaderSource Assembler::assemble() {
  const std::size_t prelude = fileNumber("<prelude>");
  addLine("#version 450 core", {prelude, 0});
  int lineNumber = 0;
  for (const std::string_view line : splitLines(request_.prelude)) {
    addLine(line, {prelude, ++lineNumber});
  }
  const std::string path = resolve(request_.main);
  if (const auto file = find(path)) {
    appendFile(path, *file);
  } else {
    complain({std::string(kRootPrefix) + path, 0, 0},
             "found no such file, expected a file of the shader library");
  }
  if (!diagnostics_.empty()) throw FileError(std::move(diagnostics_));
  return std::move(source_);
}

void Assembler::appendFile(const std::string& path, const ShaderFile& file) {
  const std::size_t number = fileNumber(file.displayName);
  open_.push_back(path);
  int lineNumber = 0;
  for (const std::string_view line : splitLines(file.text)) {
    ++lineNumber;
    if (isPragmaOnce(line)) {
      once_.insert(path);
      addLine("", {number, lineNumber});
    } else if (const auto argument = afterDirective(line, "include")) {
      const auto column = static_cast<int>(argument->data() - line.data()) + 1;
      include(*argument, {file.displayName, lineNumber, column});
    } else {
      addLine(line, {number, lineNumber});
    }
  }
  open_.pop_back();
}

void Assembler::include(std::string_view argument, const SourceLocation& location) {
  const auto asked = quoted(argument);
  if (!asked) {
    complain(location, "found #include " + std::string(argument) + ", expected #include \"path\"");
    return;
  }
  const std::string path = resolve(*asked);
  if (once_.contains(path)) return;
  const auto file = find(path);
  if (!file) {
    complain(location, "found #include of \"" + path + "\", expected a file of the shader library");
  } else if (std::find(open_.begin(), open_.end(), path) != open_.end()) {
    complain(location,
             "found #include of \"" + path + "\" inside itself, expected no cycle or #pragma once");
  } else {
    appendFile(path, *file);
  }
}

std::string Assembler::resolve(const std::string& path) const {
  const std::string relative = withoutRoot(path);
  const auto alias = request_.aliases.find(relative);
  return alias != request_.aliases.end() ? alias->second : relative;
}

std::optional<ShaderFile> Assembler::find(const std::string& path) const {
  const auto generated = request_.virtualFiles.find(path);
  if (generated != request_.virtualFiles.end()) {
    return ShaderFile{generated->second, "<" + path + ">"};
  }
  return library_.find(path);
}

std::size_t Assembler::fileNumber(const std::string& displayName) {
  auto& files = source_.files;
  const auto known = std::find(files.begin(), files.end(), displayName);
  if (known != files.end()) return static_cast<std::size_t>(known - files.begin());
  files.push_back(displayName);
  return files.size() - 1;
}

void Assembler::addLine(std::string_view line, ShaderSource::Line place) {
  source_.text += request_.stripPrecise ? blankOut(std::string(line), "precise") : line;
  source_.text += '\n';
  source_.lines.push_back(place);
}

void Assembler::complain(const SourceLocation& location, const std::string& message) {
  diagnostics_.push_back({location, message});
}

}  // namespace

ShaderLibrary::ShaderLibrary(std::filesystem::path directory, const Overrides& overrides)
    : directory_(std::move(directory)) {
  for (const auto& [path, replacement] : overrides) {
    const std::string relative = withoutRoot(path);
    if (!findOriginal(relative)) {
      throw UsageError("override of shaders/" + relative +
                       ": found no such file, expected a file of the shader library" +
                       didYouMean(relative, paths()));
    }
    overrides_[relative] = replacement;
  }
}

void ShaderLibrary::add(const std::string& path, ShaderOverride file) {
  overrides_[withoutRoot(path)] = std::move(file);
}

std::optional<ShaderFile> ShaderLibrary::find(const std::string& path) const {
  const auto replacement = overrides_.find(path);
  if (replacement == overrides_.end()) return findOriginal(path);
  const auto& [text, origin] = replacement->second;
  return ShaderFile{text, origin.empty() ? std::string(kRootPrefix) + path : origin};
}

std::vector<std::string> ShaderLibrary::paths() const {
  std::vector<std::string> found;
  if (directory_.empty()) {
    for (const EmbeddedShader& shader : embeddedShaders()) found.emplace_back(shader.path);
    return found;
  }
  std::error_code failed;
  for (std::filesystem::recursive_directory_iterator at(directory_, failed), end;
       !failed && at != end; at.increment(failed)) {
    if (at->path().extension() != ".glsl") continue;
    found.push_back(at->path().lexically_relative(directory_).generic_string());
  }
  std::ranges::sort(found);
  return found;
}

std::optional<ShaderFile> ShaderLibrary::findOriginal(const std::string& path) const {
  if (!directory_.empty()) {
    const std::filesystem::path file = directory_ / path;
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file)) return std::nullopt;
    return ShaderFile{{std::istreambuf_iterator<char>(stream), {}}, file.string()};
  }
  const auto shaders = embeddedShaders();
  const auto found = std::ranges::find(shaders, path, &EmbeddedShader::path);
  if (found == shaders.end()) return std::nullopt;
  return ShaderFile{std::string(found->text), std::string(kRootPrefix) + path};
}

ShaderSource assembleShader(const ShaderLibrary& library, const ShaderRequest& request) {
  return Assembler(library, request).assemble();
}

std::string ShaderSource::mapLog(std::string_view log) const {
  std::string mapped;
  for (const std::string_view view : splitLines(log)) {
    const std::string line(view);
    const LogPlace place = parseLogPlace(line.c_str());
    const auto index = static_cast<std::size_t>(place.line) - 1;
    if (place.line >= 1 && index < lines.size()) {
      const auto [file, number] = lines[index];
      mapped += SourceLocation{files[file], number, place.column}.toString() + ": " +
                line.substr(static_cast<std::size_t>(place.length)) + "\n";
    } else {
      mapped += line + "\n";
    }
  }
  return mapped;
}

}  // namespace twintrace
