#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/scene/option_names.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/compare_text.h"
#include "experiments/cli/interrupt.h"
#include "experiments/cli/progress_display.h"
#include "experiments/cli/scene_input.h"
#include "experiments/cli/shared_options.h"
#include "experiments/compare_files.h"
#include "experiments/explain/difference_classes.h"
#include "experiments/outputs.h"
#include "experiments/passport/stored_passports.h"

namespace twintrace {
namespace {

class CompareCommand {
 public:
  explicit CompareCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "compare",
                         "render a scene in two ways, or read two pictures, and compare");
    syntax.option("inputs", inputs_, "a scene file, or two pictures")
        .required()
        .typeName("SCENE | A.exr B.exr");
    syntax.option("--a", listA_, "options of arm a; its backend is cpu unless said")
        .typeName("KEY=VAL,...");
    syntax.option("--b", listB_, "options of arm b; its backend is gpu unless said")
        .typeName("KEY=VAL,...");
    syntax.option("--stderr-a", errorsA_, "standard errors of picture A").typeName("SA.exr");
    syntax.option("--stderr-b", errorsB_, "standard errors of picture B").typeName("SB.exr");
    syntax.option("--out", directory_, "directory for pictures, maps and compare.json")
        .typeName("DIR");
    syntax.option("--alpha", settings_.alpha, "false alarms of the tests, 0.001 unless said");
    syntax.option("--bound", settings_.bound,
                  "relative difference of means that counts as equal, 0.005 unless said");
    syntax.option("--repeats", settings_.repeats, "timed runs of each arm; the fastest counts");
    addAnswerOptions(syntax, answer_);
    addRenderOptions(syntax, given_);
    return syntax.app();
  }

  int run() {
    checkSettings(settings_);
    if (inputs_.size() > 2) {
      throw UsageError(
          fmt::format("found {} inputs, expected a scene or two pictures", inputs_.size()));
    }
    return inputs_.size() == 1 ? runArms() : runFiles();
  }

 private:
  int runArms() {
    if (!errorsA_.empty() || !errorsB_.empty()) {
      throw UsageError("found --stderr-a or --stderr-b with a scene, expected two pictures");
    }
    const Scene scene = openScene(console_, inputs_.front());
    ArmOptions options = armOptions(scene.render);
    const bool paired = isPaired(options);
    std::vector<std::string> notes = fitForTests(options);
    prepareOutputs();
    Arm a = openArm(scene, options.a);
    Arm b = openArm(scene, options.b);
    warnOfUnusedOverrides(console_, "a", a);
    warnOfUnusedOverrides(console_, "b", b);
    warnOfStrictness(a, b);
    const Json passports = knownPassports(a, b);
    ArmsComparison result = render(a, b, paired);
    auto& allNotes = result.comparison.notes;
    allNotes.insert(allNotes.begin(), notes.begin(), notes.end());

    const ArmNames names = armNames(options);
    finish(result.comparison, compareJson(scene, a, b, result, settings_), armsText(result, names),
           names);
    if (!passports.empty()) writeText(outputPath(kPassports), jsonText(passports));
    warnOfBadFrames(console_, "a", result.a.film);
    warnOfBadFrames(console_, "b", result.b.film);
    const bool interrupted =
        result.a.stoppedBy == StopReason::interrupt || result.b.stoppedBy == StopReason::interrupt;
    return interrupted ? kInterrupted : exitCode(result.comparison);
  }

  void warnOfStrictness(const Arm& a, const Arm& b) const {
    const std::string ofA = strictWarning(a);
    const std::string ofB = strictWarning(b);
    warn(console_, ofA);
    if (ofA != ofB) warn(console_, ofB);
  }

  /// The passports to keep beside the results, compared with those of the results that are there.
  Json knownPassports(const Arm& a, const Arm& b) const {
    if (directory_.empty()) return {};
    const Json passports = armPassports(a, b);
    for (const std::string& text : passportWarnings(outputPath(kPassports), passports)) {
      warn(console_, text);
    }
    return passports;
  }

  int runFiles() {
    if (!given_.empty() || !listA_.empty() || !listB_.empty()) {
      throw UsageError("found options of rendering with two pictures, expected a scene");
    }
    for (const std::string& input : inputs_) {
      if (input.ends_with(".toml")) {
        throw UsageError("found the scene " + quote(input) +
                         " and another input, expected one "
                         "scene or two pictures");
      }
    }
    prepareOutputs();
    const PictureFiles files{inputs_[0], inputs_[1], errorsA_, errorsB_};
    const Comparison comparison = compareFiles(files, settings_);
    finish(comparison, compareJson(files, comparison, settings_), "", {files.a, files.b});
    return exitCode(comparison);
  }

  /// An arm has the options of both, then its own; without --backend, a is cpu and b is gpu.
  ArmOptions armOptions(const RenderOptions& ofScene) const {
    const RenderOptions common = layOptions(ofScene, given_);
    const GivenOptions givenA = givenFor("cpu", listA_);
    const GivenOptions givenB = givenFor("gpu", listB_);
    ArmOptions options{setArm("--a", common, givenA), setArm("--b", common, givenB)};
    checkArms(options);
    checkOverrides(options);
    const bool liftA = stopRuleDecides(options.a, givenA);
    const bool liftB = stopRuleDecides(options.b, givenB);
    // The limits must not unpair arms: the first rule that holds stops both.
    const bool liftBoth = isPaired(options) && (liftA || liftB);
    if (liftA || liftBoth) liftSampleLimit(options.a);
    if (liftB || liftBoth) liftSampleLimit(options.b);
    return options;
  }

  static void checkOverrides(const ArmOptions& options) {
    const bool given = !options.a.shaderOverrides.empty() || !options.b.shaderOverrides.empty();
    const bool onGpu = options.a.backend == BackEnd::gpu || options.b.backend == BackEnd::gpu;
    if (!given || onGpu) return;
    throw UsageError("found --override with two arms of backend cpu, expected backend gpu");
  }

  GivenOptions givenFor(const char* backEnd, const std::string& armList) const {
    GivenOptions given = given_;
    if (!given.has("backend")) given.list.emplace_back("backend", backEnd);
    given.armList = armList;
    return given;
  }

  static RenderOptions setArm(const char* name, const RenderOptions& common,
                              const GivenOptions& given) {
    try {
      const RenderOptions options = layOptions(common, given);
      checkOptions(options);
      return options;
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("{}: {}", name, error.what()));
    }
  }

  void prepareOutputs() const {
    if (!directory_.empty()) prepareDirectory(directory_);
    checkAnswer(answer_);
    if (directory_.empty() || answer_.json.empty() || answer_.json == "-") return;
    for (const char* name : kComparisonFiles) checkDistinct({outputPath(name), answer_.json});
  }

  ArmsComparison render(Arm& a, Arm& b, bool paired) const {
    const InterruptScope interrupt;
    ProgressDisplay display(console_.err, ProgressDisplay::styleForStandardError(answer_.quiet));
    const JobControl control{[&](const JobProgress& state) { display.show(state); },
                             [&] { return interrupt.interrupted(); }};
    ArmsComparison result = compareArms(a, b, paired, settings_, control);
    addDifferenceClasses(result, a, b, control);
    return result;
  }

  void finish(const Comparison& comparison, const Json& json, const std::string& timesText,
              const ArmNames& names) const {
    const std::string text = verdictText(comparison, settings_) + timesText;
    OutputAttempts outputs;
    outputs.attempt([&] { answer(console_, answer_, json, text); });
    if (directory_.empty()) return outputs.finish();
    outputs.attempt([&] { writeText(outputPath("compare.json"), jsonText(json)); });
    writeComparisonPictures(outputs, directory_, comparison, sheetHeader(text), names.a, names.b);
    outputs.finish();
    printText(console_, answer_, "pictures in " + directory_ + ": sheet.png shows all\n");
  }

  std::string outputPath(const char* name) const {
    return (std::filesystem::path(directory_) / name).string();
  }

  static constexpr const char* kPassports = "passport.json";

  static int exitCode(const Comparison& comparison) {
    return agrees(comparison.verdict) ? kAgree : kDiffer;
  }

  Console console_;
  std::vector<std::string> inputs_;
  std::string listA_;
  std::string listB_;
  std::string errorsA_;
  std::string errorsB_;
  std::string directory_;
  ComparisonSettings settings_;
  AnswerOptions answer_;
  GivenOptions given_;
};

}  // namespace

Command addCompareCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<CompareCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
