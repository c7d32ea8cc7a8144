#pragma once

#include <string>
#include <vector>

#include "experiments/arm.h"
#include "experiments/results_json.h"

namespace twintrace {

/// Passports of the gpu arms by the arms' names, in the shape of passport.json; empty without one.
/// @throws DeviceError if an arm's GL has gone.
Json armPassports(const Arm& a, const Arm& b);

/// What a run says whose directory holds passports of an earlier one: a line for each arm whose
/// device has changed, with the facts that differ. A file that is missing or not readable as JSON
/// says nothing.
std::vector<std::string> passportWarnings(const std::string& path, const Json& passports);

/// The warning of an arm that runs strict maths on a GL that can't be strict; empty if all is well.
std::string strictWarning(const Arm& arm);

}  // namespace twintrace
