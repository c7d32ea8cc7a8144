#pragma once

#include <string>
#include <vector>

#include "experiments/cast/jury.h"
#include "experiments/results_json.h"

namespace twintrace {

/// The report as a table of two lines per engine, for 100 columns.
std::string reportText(const JuryReport& report);

/// Reports as one line each: wrong answers on clean rays, and the share of wrong answers among all.
std::string summaryText(const std::vector<JuryReport>& reports);

/// What the reports say together: whether an engine to be trusted is wrong, and which.
std::string juryVerdictText(const std::vector<JuryReport>& reports);

/// The disagreements with all numbers as hex floats, at most `count`.
std::string disagreementsText(const JuryReport& report, std::size_t count);

/// The same as JSON, disagreements left out.
Json reportJson(const JuryReport& report);

}  // namespace twintrace
