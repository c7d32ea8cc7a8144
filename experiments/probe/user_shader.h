#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/probe/shader_function.h"
#include "gpu/glsl_text.h"
#include "gpu/probe.h"

namespace twintrace::probe {

/// The values that a parameter of a user's function is drawn from.
struct UserRange {
  double low = 0;
  double high = 0;
  bool unit = false;  ///< a vector of length 1 instead
};

/// A parameter or the result of a user's function, as words.
struct UserValue {
  std::string type;  ///< as in "vec3"
  std::string name;  ///< "result" for the result
  Kind kind = Kind::real;
  int size = 1;  ///< words
  GlslDirection direction = GlslDirection::in;
  std::optional<UserRange> range;

  bool isInput() const { return direction != GlslDirection::out; }
};

/// A function of a user's file whose values can be packed into words.
struct UserFunction {
  std::string name;
  std::string signature;
  SourceLocation place;
  std::vector<UserValue> parameters;
  std::optional<UserValue> result;  ///< nothing for void

  std::vector<UserValue> inputs() const;   ///< in and inout parameters, in order
  std::vector<UserValue> outputs() const;  ///< the result, then out and inout parameters
};

/// A user's file of shader functions.
struct UserShader {
  std::string path;
  std::string text;  ///< with #version blanked out
  std::vector<UserFunction> functions;
};

/// Words of one record of such values; at least 1.
int wordCount(const std::vector<UserValue>& values);

/// Reads a user's file. Parameters and results may be float, int, uint, bool, vec2-4, ivec2-4 and
/// uvec2-4. A comment `// twintrace: x in [0, 1], n unit` above or in a function restricts what its
/// parameters are drawn from.
/// @param names functions to take, by name; empty = all.
/// @throws IoError if it can't be read; FileError for types that can't be packed and for comments
/// that can't be read; UsageError for an unknown name.
UserShader readUserShader(const std::string& path, const std::vector<std::string>& names);

/// As readUserShader, from a text.
UserShader parseUserShader(const std::string& text, const std::string& path,
                           const std::vector<std::string>& names);

/// Where the assembled program finds the user's file.
inline constexpr const char* kUserPath = "user.glsl";

/// The compute main that runs the function over records of its inputs.
Probe userProbe(const UserFunction& function);

}  // namespace twintrace::probe
