#pragma once

#include <functional>
#include <vector>

#include "experiments/cli/console.h"

namespace CLI {
class App;
}  // namespace CLI

namespace twintrace {

/// A subcommand of the program: its options, and what it does once they are parsed.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;  ///< returns the exit code
};

Command addRenderCommand(CLI::App& program, const Console& console);
Command addCompareCommand(CLI::App& program, const Console& console);
Command addCastCommand(CLI::App& program, const Console& console);
Command addExplainCommand(CLI::App& program, const Console& console);
Command addImportCommand(CLI::App& program, const Console& console);
Command addMergeCommand(CLI::App& program, const Console& console);
Command addPickCommand(CLI::App& program, const Console& console);
Command addProbeCommand(CLI::App& program, const Console& console);
Command addHullsCommand(CLI::App& program, const Console& console);
Command addInfoCommand(CLI::App& program, const Console& console);

}  // namespace twintrace
