#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/shader_source.h"

namespace twintrace {

class Context;

/// Expressions of GLSL that a compute shader evaluates once per record.
///
/// A record is three floats: a, b and c in the expressions.
struct RecordProgram {
  /// Includes and constants that the expressions need.
  std::string head;
  /// Of type float; or of type uint behind kBitsPrefix.
  std::vector<std::string> expressions;
  /// Whether results are declared precise, and the qualifier is kept in what is included.
  bool precise = true;
  /// Whether each expression has its own records: all of the first, then all of the second, ...
  bool ownInputs = false;
};

inline constexpr int kRecordWords = 3;
inline constexpr std::string_view kBitsPrefix = "bits:";

/// The program's whole text, with the library's files. @throws FileError for a missing include.
ShaderSource recordSource(const ShaderLibrary& library, const RecordProgram& program);

/// Evaluates the expressions for each record.
/// @param inputs bits of a, b and c of each record, one after the other; not empty.
/// @return the words of the first expression for all records, then those of the second, ...
/// @throws DeviceError if the driver rejects the program or the device fails.
std::vector<std::uint32_t> runRecords(Context& context, const ShaderSource& source,
                                      const RecordProgram& program,
                                      std::span<const std::uint32_t> inputs);

}  // namespace twintrace
