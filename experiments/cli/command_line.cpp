#include "experiments/cli/command_line.h"

#include <algorithm>
#include <CLI/CLI.hpp>
#include <new>
#include <ostream>
#include <sstream>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "experiments/build_info.h"
#include "experiments/cli/command.h"

namespace twintrace {
namespace {

/// Prints a message, `twintrace: ` before each line.
void complain(const Console& console, const std::string& message) {
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) {
    console.err << "twintrace: " << line << "\n";
  }
  console.err << std::flush;
}

/// The program's options and commands.
class Program {
 public:
  explicit Program(const Console& console)
      : console_(console),
        app_(
            "One scene, two tracers, one verdict: renders a scene on CPU and GPU and compares "
            "the results to the bit.",
            "twintrace") {
    app_.set_version_flag("--version", "twintrace " + buildInfo().version);
    app_.require_subcommand(1);
    commands_ = {addRenderCommand(app_, console_),  addCompareCommand(app_, console_),
                 addCastCommand(app_, console_),    addMergeCommand(app_, console_),
                 addPickCommand(app_, console_),    addProbeCommand(app_, console_),
                 addExplainCommand(app_, console_), addHullsCommand(app_, console_),
                 addImportCommand(app_, console_),  addInfoCommand(app_, console_)};
    // Left-over words are judged here, with a suggestion.
    for (const Command& command : commands_) command.app->allow_extras();
  }

  int run(const std::vector<std::string>& arguments) {
    checkCommand(arguments);
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    try {
      app_.parse(reversed);
    } catch (const CLI::Success& wish) {
      return app_.exit(wish, console_.out, console_.err);
    } catch (const CLI::ParseError& error) {
      checkExtras();
      throw UsageError(error.what());
    }
    checkExtras();
    return chosenCommand().run();
  }

 private:
  void checkCommand(const std::vector<std::string>& arguments) const {
    std::vector<std::string> names;
    for (const Command& command : commands_) names.push_back(command.app->get_name());
    const auto isOption = [](const std::string& word) { return word.starts_with("-"); };
    if (arguments.empty()) throw UsageError("found no command, expected " + oneOf(names));
    const std::string& word = arguments.front();
    if (isOption(word) || std::find(names.begin(), names.end(), word) != names.end()) return;
    throw UsageError("found command " + quote(word) + ", expected " + oneOf(names) +
                     didYouMean(word, names));
  }

  const Command& chosenCommand() const {
    return *std::find_if(commands_.begin(), commands_.end(),
                         [](const Command& command) { return command.app->parsed(); });
  }

  /// @throws UsageError for words that the command did not take.
  void checkExtras() const {
    const std::vector<std::string> own = app_.remaining();
    if (!own.empty()) complainOf(own.front(), app_);
    for (const Command& command : commands_) {
      const std::vector<std::string> rest = command.app->remaining();
      if (!rest.empty()) complainOf(rest.front(), *command.app);
    }
  }

  [[noreturn]] static void complainOf(const std::string& word, const CLI::App& app) {
    if (!word.starts_with("-")) {
      throw UsageError("found " + quote(word) + ", expected no further argument");
    }
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::string name = word.substr(0, word.find('='));
    throw UsageError("found option " + quote(name) + ", expected an option of " + app.get_name() +
                     " (see --help)" + didYouMean(name, names));
  }

  Console console_;
  CLI::App app_;
  std::vector<Command> commands_;
};

}  // namespace

int runCommandLine(std::vector<std::string> arguments, Console console) {
  try {
    return Program(console).run(arguments);
  } catch (const UsageError& error) {
    complain(console, error.what());
    return kBadInput;
  } catch (const FileError& error) {
    complain(console, error.what());
    return kBadInput;
  } catch (const DeviceError& error) {
    complain(console, error.what());
    return kNoDevice;
  } catch (const IoError& error) {
    complain(console, error.what());
    return kNoFile;
  } catch (const std::bad_alloc&) {
    complain(console, "out of memory: expected a smaller film or scene");
    return kBadInput;
  } catch (const std::exception& error) {
    complain(console, std::string("internal error: ") + error.what());
    return kBadInput;
  }
}

}  // namespace twintrace
