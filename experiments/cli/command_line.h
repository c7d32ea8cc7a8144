#pragma once

#include <string>
#include <vector>

#include "experiments/cli/console.h"

namespace twintrace {

/// Exit codes of design section 6.
enum ExitCode {
  kAgree = 0,
  kDiffer = 1,
  kBadInput = 2,
  kNoDevice = 3,
  kNoFile = 4,
  kInterrupted = 130
};

/// Runs the program with the arguments after its name. Every error ends here: as a message on
/// console.err and an exit code.
int runCommandLine(std::vector<std::string> arguments, Console console);

}  // namespace twintrace
