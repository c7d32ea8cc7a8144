#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/explain/call_tree.h"

namespace twintrace {

/// Two corresponding statements, one of each side, that give different values.
struct StatementDifference {
  TracedValues a;
  TracedValues b;
  /// Statements of one side that the differing one is made of and that can't be compared, since the
  /// other side has no such variable: the fault may lie in one of them. Conditions that decide
  /// whether a statement is executed are not followed.
  std::vector<TracedValues> suspectsA;
  std::vector<TracedValues> suspectsB;
};

/// A word in which two values differ.
struct WordDifference {
  std::string path;
  WordKind kind = WordKind::real;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// The first differing statement of two calls with equal inputs and different outputs, in the order
/// of a.
///
/// Statements correspond if they give a value to a variable of the same name, the first to the
/// first and so on. This holds only for names that both functions assign equally often: the twins
/// are written apart, and a name assigned more often on one side means something else there. If no
/// such statement differs, the returns are named. A variable that is returned as it is, and that
/// the other side lacks, stands for the result: instead of the return, the statement that gave it
/// the differing value is named. One that gave it the other side's result is no suspect, and
/// neither is what that one is made of.
StatementDifference firstDifferingStatement(const TraceProgram& programA, const Call& a,
                                            const TraceProgram& programB, const Call& b);

/// The words in which the two statements' values differ, by the names of a.
std::vector<WordDifference> wordDifferences(const StatementDifference& statement);

}  // namespace twintrace
