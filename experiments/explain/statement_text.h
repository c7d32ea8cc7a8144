#pragma once

#include <string>

#include "experiments/explain/statements.h"
#include "experiments/results_json.h"

namespace twintrace {

/// What the two sides are called.
struct SideNames {
  std::string a;
  std::string b;
};

/// A traced word for people: a float in hex and decimal, an integer, a truth value.
std::string wordText(WordKind kind, std::uint32_t word);

/// The same as JSON: `value`, `bits`, and for floats `hex`.
Json wordJson(WordKind kind, std::uint32_t word);

/// Places, texts and differing values of two statements, and the suspects, in indented lines.
std::string statementText(const StatementDifference& statement, const SideNames& names);

/// For each side `place`, `text` and `suspects`.
Json statementJson(const StatementDifference& statement, const SideNames& names);

/// The differing words: `variable`, the value of each side, `ulp`.
Json differingJson(const StatementDifference& statement, const SideNames& names);

}  // namespace twintrace
