#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace twintrace {

/// What a 32-bit word of a traced value stands for.
enum class WordKind { real, integer, natural, truth };

/// One word of a traced value.
struct TraceSlot {
  std::string path;  ///< `ray.origin.x`
  WordKind kind = WordKind::real;
};

/// A variable, parameter or member in the types of GLSL.
struct TraceVariable {
  std::string type;
  std::string name;
};

/// The structures of a program, by name; types that are not in it are GLSL's own.
using TraceStructs = std::map<std::string, std::vector<TraceVariable>>;

/// Whether values of the type can be traced: float, int, uint, bool, double (rounded to float),
/// vectors and structures of such.
bool isTraceable(const TraceStructs& structs, const std::string& type);

/// The words of a variable of a traceable type, in the order of its members.
std::vector<TraceSlot> traceSlots(const TraceStructs& structs, const TraceVariable& variable);

/// A function whose calls are recorded.
struct TraceFunction {
  std::string name;
  std::string result;  ///< its type
  std::vector<TraceVariable> parameters;
  std::string place;  ///< `file:line` of its definition
};

/// A place in a program where something is recorded.
struct TraceSite {
  enum class Kind { enter, leave, local };
  Kind kind = Kind::enter;
  int function = 0;  ///< index into TraceProgram::functions
  std::string place;  ///< `file:line`
  std::vector<TraceSlot> slots;
  std::string text;  ///< of the statement, white space made single; empty for enter
};

/// A function's name and the types of its parameters, as in `dot3(vec3, vec3)`.
std::string signatureOf(const TraceFunction& function);

/// What the numbers in a trace mean. Built once per program.
struct TraceProgram {
  std::vector<TraceFunction> functions;
  std::vector<TraceSite> sites;
};

/// What one run recorded: for each event the number of its site, then the words of its slots.
struct CallTrace {
  std::vector<std::uint32_t> words;
  std::array<float, 3> radiance{};  ///< of the sample that was run
  std::uint64_t lost = 0;           ///< events for which there was no room
};

}  // namespace twintrace
