#pragma once

#include <string>
#include <vector>

#include "experiments/probe/trial.h"
#include "experiments/results_json.h"

namespace twintrace::probe {

/// Verdict, counts, histograms and worst records of one function; floats are also given as hex.
Json trialJson(const FunctionTrial& trial);

/// Inputs and all answers of a record, slot by slot.
Json recordJson(const ShaderFunction& function, const Record& record);

/// A line per function under a heading, then the first difference of each that differs.
std::string trialsText(const std::vector<FunctionTrial>& trials);

/// Inputs and all answers of a record in lines, distances to the shader's answers in ulp.
std::string recordText(const ShaderFunction& function, const Record& record);

/// Reads `HEX,...` as the words of one record in slot order: a float as a decimal or C99 hex number
/// or by its bits (0x3f800000), an integer in decimal or hex, a truth value as true, false, 1 or 0.
/// @throws UsageError that names the slots for a wrong number of values, or one that isn't a value.
std::vector<std::uint32_t> parseInputs(const ShaderFunction& function, const std::string& text);

}  // namespace twintrace::probe
