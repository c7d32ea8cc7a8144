#pragma once

#include <string>

#include "experiments/probe/statement_replay.h"
#include "experiments/probe/trial.h"
#include "experiments/results_json.h"

namespace twintrace::probe {

/// The first differing statement in lines, and what a reader has to know about the replay.
/// @param record the same inputs, run by the programs as they are.
std::string statementsText(const ShaderFunction& function, const Record& record,
                           const StatementReplay& replay);

/// The same as JSON: `traced_as_plain`, `function`, `inputs`, `statement`, `differing`, `notes`.
Json statementsJson(const ShaderFunction& function, const Record& record,
                    const StatementReplay& replay);

}  // namespace twintrace::probe
