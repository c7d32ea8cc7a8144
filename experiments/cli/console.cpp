#include "experiments/cli/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "common/base/error.h"
#include "experiments/outputs.h"

namespace twintrace {
namespace {

constexpr std::size_t kPlacesShown = 3;

void print(const Console& console, const std::string& text) {
  console.out << text << std::flush;
  if (!console.out) throw IoError("standard output: cannot be written");
}

}  // namespace

void checkAnswer(const AnswerOptions& options) {
  if (!options.json.empty() && options.json != "-") checkWritable(options.json);
}

void printText(const Console& console, const AnswerOptions& options, const std::string& text) {
  if (!options.quiet && options.json != "-") print(console, text);
}

void answer(const Console& console, const AnswerOptions& options, const Json& json,
            const std::string& text) {
  OutputAttempts outputs;
  outputs.attempt([&] { printText(console, options, text); });
  outputs.attempt([&] {
    if (options.json == "-")
      print(console, jsonText(json));
    else if (!options.json.empty())
      writeText(options.json, jsonText(json));
  });
  outputs.finish();
}

void warn(const Console& console, const std::string& text) {
  if (!text.empty()) console.err << "twintrace: warning: " << text << '\n';
}

void warnOfBadFrames(const Console& console, const std::string& what, const Film& film) {
  if (film.badFrameCount() == 0) return;
  std::string places;
  const auto& bad = film.data().badPlaces;
  for (std::size_t i = 0; i < std::min(bad.size(), kPlacesShown); ++i) {
    places += fmt::format("{} pixel {},{} at sample {}", i == 0 ? "" : ",", bad[i].x, bad[i].y,
                          bad[i].firstSample);
  }
  console.err << fmt::format(
      "twintrace: warning: {}: {} frames of pixels were not finite or too large and are left out, "
      "first:{}\n",
      what, film.badFrameCount(), places);
}

void warnOfUnusedOverrides(const Console& console, const std::string& what, const Arm& arm) {
  for (const auto& [name, value] : arm.renderer->provenance()) {
    if (name != "unused_overrides") continue;
    console.err << fmt::format(
        "twintrace: warning: {}: the program does not include {}, so that the override has no "
        "effect\n",
        what, value);
  }
}

}  // namespace twintrace
