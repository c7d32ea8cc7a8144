#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/passport/passport.h"
#include "experiments/results_json.h"

namespace twintrace {

/// The passport as `info --passport --json` gives it.
Json passportJson(const Passport& passport);

/// The device's part of it: renderer, version, digest, strictness and facts.
Json deviceJson(const DevicePassport& passport);

/// The facts of deviceJson(); those that are no text are left out.
std::vector<PassportFact> factsOf(const Json& device);

}  // namespace twintrace
