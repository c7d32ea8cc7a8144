#include <fmt/format.h>

#include <memory>

#include "common/base/error.h"
#include "common/film/film_file.h"
#include "common/scene/option_names.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/interrupt.h"
#include "experiments/cli/progress_display.h"
#include "experiments/cli/scene_input.h"
#include "experiments/cli/shared_options.h"
#include "experiments/outputs.h"
#include "experiments/passport/stored_passports.h"
#include "experiments/render_job.h"

namespace twintrace {
namespace {

class RenderCommand {
 public:
  explicit RenderCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "render", "render a scene with one back end");
    syntax.option("scene", scenePath_, "scene file").required().typeName("SCENE");
    syntax.option("-o,--output", exr_, "picture with variance and count; default NAME.exr")
        .typeName("FILE.exr");
    syntax.option("--png", png_, "picture for display; default NAME.png if there is no -o")
        .typeName("FILE.png");
    syntax.option("--film", film_, "exact sums, for merge").typeName("FILE.film");
    addAnswerOptions(syntax, answer_);
    addRenderOptions(syntax, given_);
    return syntax.app();
  }

  int run() {
    const Scene scene = openScene(console_, scenePath_);
    const RenderOptions options = applyOptions(scene.render, given_);
    checkOptions(options);
    if (options.backend == BackEnd::cpu && !options.shaderOverrides.empty()) {
      throw UsageError("found --override with backend cpu, expected backend gpu");
    }
    chooseOutputs(scene.name);
    checkOutputs();
    Arm arm = openArm(scene, options);
    warnOfUnusedOverrides(console_, scene.name, arm);
    warn(console_, strictWarning(arm));
    const RenderResult result = render(arm);
    warnOfBadFrames(console_, scene.name, result.film);
    OutputAttempts attempts;
    attempts.attempt([&] {
      answer(console_, answer_, renderJson(scene, arm, result, outputs()), summary(arm, result));
    });
    writeOutputs(attempts, result.film);
    attempts.finish();
    printText(console_, answer_, outputList());
    return result.stoppedBy == StopReason::interrupt ? kInterrupted : kAgree;
  }

 private:
  void chooseOutputs(const std::string& name) {
    if (!exr_.empty()) return;
    exr_ = name + ".exr";
    if (png_.empty()) png_ = name + ".png";
  }

  void checkOutputs() const {
    checkExtension(exr_, {".exr"});
    if (!png_.empty()) checkExtension(png_, {".png"});
    if (!film_.empty()) checkExtension(film_, {".film"});
    for (const std::string& path : outputs()) checkWritable(path);
    std::vector<std::string> all = outputs();
    if (answer_.json != "-" && !answer_.json.empty()) all.push_back(answer_.json);
    checkDistinct(all);
    checkAnswer(answer_);
  }

  RenderResult render(Arm& arm) const {
    const InterruptScope interrupt;
    ProgressDisplay display(console_.err, ProgressDisplay::styleForStandardError(answer_.quiet));
    return renderFilm(arm, {[&](const JobProgress& state) { display.show(state); },
                            [&] { return interrupt.interrupted(); }});
  }

  /// The film first: all else can be made from it.
  void writeOutputs(OutputAttempts& attempts, const Film& film) const {
    if (!film_.empty()) attempts.attempt([&] { writeFilm(film_, film); });
    const ExrContent content = exrContent(film);
    attempts.attempt([&] { writeExr(exr_, content); });
    if (!png_.empty()) attempts.attempt([&] { writePng(png_, content.image); });
  }

  std::vector<std::string> outputs() const {
    std::vector<std::string> paths;
    for (const std::string& path : {exr_, png_, film_}) {
      if (!path.empty()) paths.push_back(path);
    }
    return paths;
  }

  std::string summary(const Arm& arm, const RenderResult& result) const {
    const RenderOptions& options = arm.options;
    const double samples =
        double(result.samplesPerPixel()) * double(options.width) * double(options.height);
    return fmt::format("{}x{} pixels, {} samples per pixel in {:.3f} s, {}samples/s{}\n",
                       options.width, options.height, result.samplesPerPixel(), result.seconds,
                       shortNumber(samples / result.seconds), stopText(result.stoppedBy));
  }

  std::string outputList() const {
    std::string files;
    for (const std::string& path : outputs()) files += (files.empty() ? "" : ", ") + path;
    return files + "\n";
  }

  static std::string stopText(StopReason reason) {
    if (reason == StopReason::samples) return "";
    return fmt::format(", stopped by {}", stopReasonName(reason));
  }

  Console console_;
  std::string scenePath_;
  std::string exr_;
  std::string png_;
  std::string film_;
  AnswerOptions answer_;
  GivenOptions given_;
};

}  // namespace

Command addRenderCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<RenderCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
