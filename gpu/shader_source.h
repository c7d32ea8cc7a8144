#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twintrace {

/// A text that replaces one file of the shader library.
struct ShaderOverride {
  std::string text;
  std::string origin;  ///< the name in messages; empty = as the file that is replaced
};

/// A file of the library and its name in messages.
struct ShaderFile {
  std::string text;
  std::string displayName;
};

/// Where shader files come from: the binary, or a directory read anew at each request.
class ShaderLibrary {
 public:
  using Overrides = std::map<std::string, ShaderOverride>;

  /// @param directory empty = the files embedded in the binary.
  /// @param overrides by path relative to the shader root; a leading "shaders/" is ignored.
  /// @throws UsageError for an override of a file that the library doesn't have.
  explicit ShaderLibrary(std::filesystem::path directory = {}, const Overrides& overrides = {});

  /// The file at the path relative to the shader root, or nothing.
  std::optional<ShaderFile> find(const std::string& path) const;

  /// Adds a file, or replaces one, at the path relative to the shader root.
  void add(const std::string& path, ShaderOverride file);

  /// All files, relative to the shader root, sorted.
  std::vector<std::string> paths() const;

 private:
  std::optional<ShaderFile> findOriginal(const std::string& path) const;

  std::filesystem::path directory_;
  Overrides overrides_;
};

/// What to make of the library: which main, specialised how.
struct ShaderRequest {
  std::string main;     ///< path of the file to start from; may be virtual
  std::string prelude;  ///< defines and constants, placed right after #version
  std::map<std::string, std::string> virtualFiles;  ///< generated text by path; found first
  std::map<std::string, std::string> aliases;       ///< path asked for -> path taken
  bool stripPrecise = false;                        ///< blank out the qualifier `precise`
};

/// One GLSL text for the driver, with the way back to the files it was made of. That way is a table
/// and not #line directives, since Mesa forgets their file numbers in all but syntax errors.
struct ShaderSource {
  /// Where a line of the text came from.
  struct Line {
    std::size_t file = 0;  ///< index into files
    int number = 0;        ///< from 1
  };

  std::string text;
  std::vector<std::string> files;  ///< display names
  std::vector<Line> lines;         ///< by line of the text, from 0

  /// Rewrites the places in a driver's log (Mesa and NVIDIA style) to file:line[:column].
  std::string mapLog(std::string_view log) const;
};

/// Resolves `#include "path"` (from the shader root) into one text. A file with `#pragma once`
/// comes once; includes are resolved before the GLSL preprocessor, so also inside #if.
/// @throws FileError that lists all includes that can't be resolved, with file and line.
ShaderSource assembleShader(const ShaderLibrary& library, const ShaderRequest& request);

}  // namespace twintrace
