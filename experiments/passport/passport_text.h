#pragma once

#include <string>

#include "experiments/passport/passport.h"

namespace twintrace {

/// The passport as a table for people; the last line says whether strict maths holds.
std::string passportText(const Passport& passport);

}  // namespace twintrace
