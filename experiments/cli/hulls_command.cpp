#include <algorithm>
#include <memory>
#include <ostream>
#include <sstream>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/hulls/hull_structure.h"
#include "common/scene/reader.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/interrupt.h"
#include "experiments/cli/progress_display.h"
#include "experiments/cli/scene_input.h"
#include "experiments/cli/shared_options.h"
#include "experiments/hulls/heat_map.h"
#include "experiments/hulls/hull_page.h"
#include "experiments/hulls/hull_results.h"
#include "experiments/outputs.h"

namespace twintrace {
namespace {

constexpr const char* kJsonFile = "hulls.json";
constexpr const char* kCsvFile = "hulls.csv";
constexpr const char* kPageFile = "hulls.html";
constexpr int kMostRepeats = 1000;
constexpr int kMostRays = 1 << 24;

std::vector<std::string> splitList(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

std::vector<std::string> allStrategies() {
  std::vector<std::string> names;
  for (const HullStrategy& strategy : hullStrategies()) names.push_back(strategy.name);
  return names;
}

std::vector<RayKind> parseKinds(const std::string& list) {
  const std::vector<std::string> known(kRayKindNames.begin(), kRayKindNames.end());
  std::vector<RayKind> kinds;
  for (const std::string& word : splitList(list)) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) {
      throw UsageError("rays: found " + quote(word) + ", expected a list of " + oneOf(known) +
                       didYouMean(word, known));
    }
    kinds.push_back(static_cast<RayKind>(found - known.begin()));
  }
  return kinds;
}

class HullsCommand {
 public:
  explicit HullsCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "hulls", "measure hull strategies, and what they cost");
    syntax.option("scene", scenes_, "scene files").typeName("SCENE...");
    syntax.flag("--list", list_, "name all strategies, a line each, and do nothing else");
    syntax.option("--strategies", strategies_, "comma-separated; all if not given").typeName("LIST");
    syntax.option("--rays", kinds_, "primary, shadow and diffuse").showDefault().typeName("LIST");
    syntax.option("--engines", engines_, "cpu, cpu64, gpu, embree and embree-fast").showDefault().typeName("LIST");
    syntax.option("--repeats", repeats_, "times that each is timed").range(1, kMostRepeats).showDefault();
    syntax.option("--most-rays", mostRays_, "of a kind; of more, evenly spaced ones are taken")
        .range(1, kMostRays)
        .showDefault();
    syntax.option("--out", directory_, "also write hulls.html, hulls.json and hulls.csv there")
        .typeName("DIR");
    syntax.flag("--heat", heat_, "also write to --out what each pixel costs, as SCENE-STRATEGY.png");
    addAnswerOptions(syntax, answer_);
    addRenderOptions(syntax, given_);
    return syntax.app();
  }

  /// @return 1 if strategies answer differently.
  int run() const {
    if (list_) return listStrategies();
    if (given_.has("hull")) throw UsageError("found --hull, expected --strategies");
    if (scenes_.empty()) throw UsageError("found no scene, expected at least one");
    const HullPlan plan = makePlan();
    if (heat_ && directory_.empty()) throw UsageError("found --heat without --out, expected both");
    checkAnswer(answer_);
    if (!directory_.empty()) prepareDirectory(directory_);
    std::vector<HullRun> runs;
    InterruptScope interrupt;
    for (const std::string& path : scenes_) {
      const Scene scene = openScene(console_, path);
      const RenderOptions options = applyOptions(scene.render, given_);
      const std::vector<HullRun> measured =
          measureHulls(scene, options, plan, control(interrupt));
      runs.insert(runs.end(), measured.begin(), measured.end());
      if (interrupt.interrupted()) break;
    }
    tell(runs);
    if (heat_ && !interrupt.interrupted()) drawHeat(plan);
    if (interrupt.interrupted()) return kInterrupted;
    const bool agree = std::ranges::all_of(runs, [](const HullRun& run) { return run.differing == 0; });
    return agree ? kAgree : kDiffer;
  }

 private:
  int listStrategies() const {
    for (const std::string& name : allStrategies()) console_.out << name << "\n";
    return kAgree;
  }

  HullPlan makePlan() const {
    HullPlan plan;
    plan.strategies = strategies_.empty() ? allStrategies() : splitList(strategies_);
    plan.kinds = parseKinds(kinds_);
    plan.engines = chosenEngines();
    plan.repeats = repeats_;
    plan.mostRays = mostRays_;
    return plan;
  }

  /// --engines, or the one that --backend and --precision name.
  std::vector<std::string> chosenEngines() const {
    if (!given_.has("backend") && !given_.has("precision")) return splitList(engines_);
    const RenderOptions options = layOptions(RenderOptions{}, given_);
    if (options.backend == BackEnd::gpu) return {"gpu"};
    return {options.precision == Precision::float64 ? "cpu64" : "cpu"};
  }

  JobControl control(const InterruptScope& interrupt) const {
    const auto display = std::make_shared<ProgressDisplay>(
        console_.err, ProgressDisplay::styleForStandardError(answer_.quiet));
    return {[display](const JobProgress& state) { display->show(state); },
            [&interrupt] { return interrupt.interrupted(); }};
  }

  /// After all else is written: what fails here loses nothing.
  void drawHeat(const HullPlan& plan) const {
    for (const std::string& path : scenes_) {
      const Scene scene = readScene(path);
      RenderOptions options = applyOptions(scene.render, given_);
      options.maths = Maths::strict;  // as all strategies have it
      for (const std::string& strategy : plan.strategies) {
        const auto counts = primaryCounts(scene, options, strategy);
        writePng(directory_ + "/" + scene.name + "-" + strategy + ".png",
                 drawHeatMap(options.width, options.height, counts, scene.name + ", " + strategy));
      }
    }
  }

  void tell(const std::vector<HullRun>& runs) const {
    const std::vector<HullCost> costs = fitCosts(runs);
    const Json json = hullJson(runs, costs);
    OutputAttempts outputs;
    if (!directory_.empty()) {
      outputs.attempt([&] { writeText(directory_ + "/" + kJsonFile, jsonText(json)); });
      outputs.attempt([&] { writeText(directory_ + "/" + kCsvFile, hullCsv(runs)); });
      outputs.attempt([&] { writeText(directory_ + "/" + kPageFile, hullPage(runs, costs)); });
    }
    outputs.attempt([&] { answer(console_, answer_, json, hullTable(runs) + costTable(costs)); });
    outputs.finish();
  }

  Console console_;
  std::vector<std::string> scenes_;
  std::string strategies_;
  std::string kinds_ = "primary,shadow,diffuse";
  std::string engines_ = "cpu,gpu";
  int repeats_ = HullPlan{}.repeats;
  int mostRays_ = HullPlan{}.mostRays;
  std::string directory_;
  bool heat_ = false;
  bool list_ = false;
  AnswerOptions answer_;
  GivenOptions given_;
};

}  // namespace

Command addHullsCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<HullsCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
