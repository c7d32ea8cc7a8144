#pragma once

#include <optional>

#include "experiments/explain/call_tree.h"
#include "experiments/explain/statements.h"

namespace twintrace {

/// The first call whose inputs agree and whose output differs, with no call inside that explains it.
struct Divergence {
  int a = 0;  ///< indices into the two trees
  int b = 0;
  int step = -1;  ///< vertex of the path at which it lies; -1 = the camera ray
  StatementDifference statement;  ///< the first one inside that differs
};

/// Compares two trees call by call. Calls match if function and inputs are the same, whatever their
/// order within the caller, since C++ leaves the order of arguments open; those that only one side
/// has, by functions without a twin or by an early way out, are passed over.
std::optional<Divergence> firstDivergence(const CallTree& a, const CallTree& b);

}  // namespace twintrace
