#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/trace/call_trace.h"

namespace twintrace {

/// Some values that were recorded together.
struct TracedValues {
  const TraceSite* site = nullptr;  ///< null: never recorded
  std::span<const std::uint32_t> words;
};

/// One call of a function.
struct Call {
  int function = -1;  ///< index into the program's functions; -1 for the sample as a whole
  TracedValues inputs;
  TracedValues output;
  std::vector<TracedValues> locals;
  std::vector<int> children;  ///< indices into CallTree::calls, in order of time
};

/// The calls of a sample; the first stands for the sample as a whole. Views into a trace and its
/// program, which have to outlive it.
struct CallTree {
  const TraceProgram* program = nullptr;
  std::vector<Call> calls;

  /// The name of a call's function; "sample" for the first.
  std::string_view name(int call) const;

  /// Calls of a function at and below a call, in order of time; not those inside a found one.
  std::vector<int> find(int from, std::string_view function) const;
};

CallTree buildCallTree(const TraceProgram& program, const CallTrace& trace);

/// Whether two words are the same result: bits, but NaN equals NaN and the sign of zero is free.
bool sameWord(WordKind kind, std::uint32_t a, std::uint32_t b);

/// The same for all words of two records; false for records of different shapes.
bool sameValues(const TracedValues& a, const TracedValues& b);

/// The word of a slot, if the record has it.
std::optional<std::uint32_t> wordOf(const TracedValues& values, std::string_view path);

/// A float slot; NaN if the record hasn't it.
float realOf(const TracedValues& values, std::string_view path);

/// Three float slots `path.x`, `.y` and `.z`.
std::array<float, 3> vectorOf(const TracedValues& values, const std::string& path);

}  // namespace twintrace
