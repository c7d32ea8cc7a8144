#pragma once

#include <iosfwd>
#include <string>

#include "experiments/results_json.h"

namespace twintrace {

/// Where the program talks: results to `out`, progress, warnings and errors to `err`.
struct Console {
  std::ostream& out;
  std::ostream& err;
};

/// The options of every command that say where its answer goes.
struct AnswerOptions {
  std::string json;  ///< file, `-` for standard output, empty for none
  bool quiet = false;
};

/// Checks before the work that the JSON can be written. @throws IoError if not.
void checkAnswer(const AnswerOptions& options);

/// Prints a text for people. It is left out if quiet or if the JSON goes to standard output, where
/// nothing else may stand then. @throws IoError if it can't be written.
void printText(const Console& console, const AnswerOptions& options, const std::string& text);

/// Prints the text, then writes the JSON, even if the text could not be written.
/// @throws IoError if one can't be written.
void answer(const Console& console, const AnswerOptions& options, const Json& json,
            const std::string& text);

/// Prints a warning of one line; nothing if the text is empty.
void warn(const Console& console, const std::string& text);

/// Counted, located and never hidden: a warning about frames that were left out of a film.
void warnOfBadFrames(const Console& console, const std::string& what, const Film& film);

/// A warning about files that took the place of shaders which the arm's program doesn't include.
void warnOfUnusedOverrides(const Console& console, const std::string& what, const Arm& arm);

}  // namespace twintrace
