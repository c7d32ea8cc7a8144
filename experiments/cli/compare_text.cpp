#include "experiments/cli/compare_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "common/scene/option_names.h"
#include "experiments/cli/progress_display.h"

namespace twintrace {
namespace {

std::string differenceText(const Comparison& comparison) {
  const BitComparison& bits = comparison.bits;
  std::string text =
      fmt::format("{} of {} pixels differ, at most {} ulp; rmse {:.3g}, relmse {:.3g}\n",
                  comparison.differingPixels, bits.pixels, bits.maxUlp, bits.rmse, bits.relmse);
  if (!comparison.paired || !comparison.first) return text;
  const FirstDifference& first = *comparison.first;
  text += fmt::format("first difference: pixel {},{}", first.pixel.x, first.pixel.y);
  if (first.sample) text += fmt::format(", sample {}", *first.sample);
  const auto values = [](const std::array<float, 3>& v) {
    return fmt::format("({}, {}, {})", v[0], v[1], v[2]);
  };
  return text + ": a " + values(first.a) + ", b " + values(first.b) + "\n";
}

std::string testText(const Comparison& comparison, const ComparisonSettings& settings) {
  const FamilyTest& family = comparison.family;
  std::string text = fmt::format(
      "family test: {} of {} blocks and channels reject, smallest p {:.3g}, alpha {:.3g}\n",
      family.rejected, family.familySize, family.smallestP, settings.alpha);
  if (family.rejected > 0 && !family.different) {
    text +=
        fmt::format("family test: not confirmed by relabelling, p {:.3g}\n", family.permutationP);
  }
  return text + fmt::format("equivalence: means within {:.3g} with p {:.3g}\n", settings.bound,
                            comparison.equivalence.p);
}

/// Stop rules and threads of both arms are equal or beside the point.
std::string differingOptions(const RenderOptions& options, const RenderOptions& other) {
  const auto mine = listOptions(options);
  const auto theirs = listOptions(other);
  std::string text;
  for (std::size_t i = 0; i < mine.size(); ++i) {
    if (mine[i] == theirs[i] || mine[i].first == "backend") continue;
    text += " " + mine[i].first + "=" + mine[i].second;
  }
  return text;
}

std::string backEndName(const RenderOptions& options) {
  return findOption("backend")->get(options);
}

std::string timeLine(char arm, const std::string& name, const ArmOutcome& outcome) {
  const FilmData& film = outcome.film.data();
  const double samples = double(film.ranges.sampleCount()) * double(film.pixels.size());
  return fmt::format("{}  {:<24} {:9.3f} s  {:>8}samples/s\n", arm, name, outcome.bestSeconds(),
                     shortNumber(samples / outcome.bestSeconds()));
}

}  // namespace

ArmNames armNames(const ArmOptions& options) {
  return {backEndName(options.a) + differingOptions(options.a, options.b),
          backEndName(options.b) + differingOptions(options.b, options.a)};
}

std::string verdictText(const Comparison& comparison, const ComparisonSettings& settings) {
  std::string text = fmt::format("verdict: {}\n", verdictName(comparison.verdict));
  text += differenceText(comparison);
  if (comparison.family.wasRun()) text += testText(comparison, settings);
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  return text;
}

std::string armsText(const ArmsComparison& result, const ArmNames& names) {
  std::string text = timeLine('a', names.a, result.a) + timeLine('b', names.b, result.b);
  return text + fmt::format("time of a / time of b: {:.3f}\n",
                            result.a.bestSeconds() / result.b.bestSeconds());
}

std::vector<std::string> sheetHeader(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace twintrace
