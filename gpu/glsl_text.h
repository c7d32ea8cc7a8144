#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"

namespace twintrace {

/// Characters of a text, from `begin` up to and without `end`.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  bool operator==(const TextRange&) const = default;
};

enum class GlslDirection : std::uint8_t { in, out, inout };

/// A parameter of a function or a field of a structure.
struct GlslVariable {
  std::string type;  ///< as in "vec3", without qualifiers; arrays as in "float[4]"
  std::string name;  ///< empty for an unnamed parameter
  GlslDirection direction = GlslDirection::in;  ///< of parameters
  std::size_t place = 0;                        ///< offset of the type in the text
};

/// The definition of a function.
struct GlslFunction {
  std::string name;
  std::string result;  ///< type without qualifiers; "void" if there is none
  std::vector<GlslVariable> parameters;
  std::size_t place = 0;  ///< offset of the name
  TextRange body;         ///< from the opening brace to behind the closing one
  TextRange whole;        ///< with result, parameters and body

  /// As in `shade(vec3, float)`.
  std::string signature() const;
};

/// The definition of a structure.
struct GlslStruct {
  std::string name;
  std::vector<GlslVariable> fields;
  std::size_t place = 0;  ///< offset of the name
  TextRange whole;        ///< up to behind the semicolon
};

/// What a GLSL text defines at its outermost level, in the order of the text.
///
/// The text is read as written: macros are not expanded, and all branches of #if count. Prototypes,
/// global variables and interface blocks are passed over.
struct GlslText {
  std::string path;  ///< name in messages
  std::string text;  ///< comments and directives blanked out; all places stay where they are
  std::vector<GlslFunction> functions;
  std::vector<GlslStruct> structs;

  /// The structure of that name, or nullptr.
  const GlslStruct* findStruct(std::string_view name) const;

  /// Line and column of an offset.
  SourceLocation location(std::size_t offset) const;
};

/// The text with comments blanked out; line ends and all places stay where they are.
std::string withoutGlslComments(std::string_view text);

/// Finds the functions and structures of a GLSL text.
/// @param path the text's name in messages.
/// @throws FileError for a bracket without its partner, or a definition that ends too soon.
GlslText parseGlsl(std::string_view text, const std::string& path);

}  // namespace twintrace
