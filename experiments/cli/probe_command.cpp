#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "common/base/error.h"
#include "common/scene/option_names.h"
#include "experiments/arm.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/interrupt.h"
#include "experiments/cli/progress_display.h"
#include "experiments/cli/scene_input.h"
#include "experiments/cli/shared_options.h"
#include "experiments/probe/replay_command.h"
#include "experiments/probe/inputs.h"
#include "experiments/probe/report.h"
#include "experiments/probe/statement_report.h"
#include "experiments/probe/user_trial.h"
#include "gpu/provider.h"
#include "gpu/specialisation.h"

namespace twintrace {
namespace {

using probe::FunctionTrial;
using probe::ShaderFunction;

/// The options of rendering that decide how a function is run alone.
constexpr std::array kOptionsTaken = {"maths", "gl", "seed", "threads"};

void addProbeOption(CommandSyntax& syntax, GivenOptions& given, const char* name,
                    const std::string& help) {
  const auto store = [&given, name](const std::string& value) {
    given.list.emplace_back(name, value);
  };
  syntax.callback("--" + std::string(name), store, help).takeLast();
}

void addProbeOptions(CommandSyntax& syntax, GivenOptions& given) {
  for (const char* name : kOptionsTaken) {
    addProbeOption(syntax, given, name, findOption(name)->expected);
  }
  for (const char* name : probe::kSceneOptions) {
    addProbeOption(syntax, given, name, "with --scene: " + findOption(name)->expected);
  }
  addShaderOptions(syntax, given);
}

const ShaderFunction& onlyOne(const std::vector<const ShaderFunction*>& functions) {
  if (functions.size() == 1) return *functions.front();
  std::vector<std::string> signatures;
  for (const ShaderFunction* function : functions) signatures.emplace_back(function->signature);
  throw UsageError(fmt::format("found {} functions with --inputs, expected one of: {}",
                               functions.size(), fmt::join(signatures, "; ")));
}

class ProbeCommand {
 public:
  explicit ProbeCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(
        program, "probe",
        "run shader functions alone against their twins and the correctly rounded values");
    syntax.option("functions", names_, "names or signatures, such as dot3; all if none is given")
        .typeName("FUNCTION");
    syntax.option("--samples", samples_, "random inputs per function, beyond the special ones")
        .range(1, kMaxSamples)
        .showDefault();
    syntax
        .option("--inputs", inputs_,
                "replay one record: the function's inputs in order, as numbers or bits")
        .typeName("HEX,...");
    syntax.flag("--statements", statements_,
                "with --inputs: name the first statement whose value differs from the twin's");
    syntax
        .option("--scene", scene_,
                "with --inputs: the scene that the function reads; a small one unless said")
        .typeName("SCENE");
    syntax.option("--shader", shader_, "run the functions of this file instead")
        .typeName("FILE.glsl");
    syntax
        .option("--reference", user_.reference,
                "with --shader: a function of this program or a C++ header; the file's own "
                "text in double unless said")
        .typeName("NAME|FILE.h");
    syntax.option("--tolerance", user_.tolerance, "with --shader: ulp that count as agreement")
        .showDefault();
    addProbeOptions(syntax, given_);
    addAnswerOptions(syntax, answer_);
    return syntax.app();
  }

  int run() const {
    const RenderOptions options = layOptions(RenderOptions{}, given_);
    checkTogether();
    if (!shader_.empty()) return runUserShader(options);
    const auto functions = probe::chooseFunctions(names_);
    checkAnswer(answer_);
    return inputs_ ? runReplay(onlyOne(functions), options) : runTrials(functions, options);
  }

 private:
  /// Options that mean nothing without others.
  void checkTogether() const {
    if (shader_.empty() && !user_.reference.empty()) {
      throw UsageError("found --reference without --shader");
    }
    if (!shader_.empty() && inputs_) {
      throw UsageError("found --inputs with --shader, expected one of them");
    }
    if (statements_ && !inputs_) throw UsageError("found --statements without --inputs");
    if (!scene_.empty() && !inputs_) throw UsageError("found --scene without --inputs");
    for (const char* name : probe::kSceneOptions) {
      if (scene_.empty() && given_.has(name)) {
        throw UsageError(fmt::format("found --{} without --scene", name));
      }
    }
  }

  int runUserShader(const RenderOptions& options) const {
    const probe::UserShader shader = probe::readUserShader(shader_, names_);
    checkAnswer(answer_);
    probe::UserTrialSettings settings = user_;
    settings.samples = samples_;
    settings.seed = options.seed;
    const auto context = createContext(options.provider, options.threads);
    const auto trials = tryUserShader(*context, options, shader, settings);
    Json json = {{"shader", shader_},
                 {"renderer", context->renderer()},
                 {"seed", options.seed},
                 {"functions", Json::array()}};
    std::string text;
    bool agrees = true;
    for (const probe::UserTrial& trial : trials) {
      json["functions"].push_back(userTrialJson(trial));
      text += (text.empty() ? "" : "\n") + userTrialText(trial);
      agrees = agrees && trial.agrees();
    }
    json["provenance"] = machineJson();
    answer(console_, answer_, json, text);
    return agrees ? kAgree : kDiffer;
  }

  static constexpr std::size_t kMaxSamples = 10'000'000;

  int runTrials(const std::vector<const ShaderFunction*>& functions,
                const RenderOptions& options) const {
    const auto context = createContext(options.provider, options.threads);
    const ShaderLibrary library = shaderLibrary(options);
    const InterruptScope interrupt;
    const auto trials = tryAll(*context, library, functions, options, interrupt);
    const auto differs = [](const FunctionTrial& t) {
      return t.verdict == probe::Verdict::differs;
    };
    const auto differing = std::ranges::count_if(trials, differs);
    answer(console_, answer_, toJson(*context, options, trials),
           trialsText(trials) + summary(trials, differing, *context));
    if (interrupt.interrupted()) return kInterrupted;
    // In native maths the driver's own functions are expected to differ: a report, no check.
    return differing != 0 && options.maths == Maths::strict ? kDiffer : kAgree;
  }

  std::vector<FunctionTrial> tryAll(Context& context, const ShaderLibrary& library,
                                    const std::vector<const ShaderFunction*>& functions,
                                    const RenderOptions& options,
                                    const InterruptScope& interrupt) const {
    ProgressDisplay display(console_.err, ProgressDisplay::styleForStandardError(answer_.quiet));
    std::vector<FunctionTrial> trials;
    for (const ShaderFunction* function : functions) {
      if (interrupt.interrupted()) break;
      trials.push_back(
          tryFunction(context, library, *function, {samples_, options.seed, options.maths}));
      display.show(
          {static_cast<double>(trials.size()) / static_cast<double>(functions.size()), 0, 0});
    }
    return trials;
  }

  int runReplay(const ShaderFunction& function, const RenderOptions& options) const {
    const auto words = probe::parseInputs(function, *inputs_);
    if (statements_ && function.twin == nullptr) {
      throw UsageError(fmt::format("found --statements with {}, expected a function with a twin",
                                   function.signature));
    }
    const probe::World world = replayWorld(options);
    probe::checkInputs(function, world, words);
    const auto context = createContext(options.provider, options.threads);
    const ShaderLibrary library = shaderLibrary(options);
    const probe::Record record = replay(*context, library, function, world, words);
    Json json = recordJson(function, record);
    json["signature"] = function.signature;
    std::string text = recordText(function, record);
    if (statements_) {
      probe::StatementReplay statements;
      replayStatements(*context, library, function, world, words, statements);
      json["statements"] = statementsJson(function, record, statements);
      text += statementsText(function, record, statements);
    }
    answer(console_, answer_, json, text);
    const bool agrees = record.twin.empty() || !probe::differ(function, record.gpu, record.twin);
    return agrees || world.options.maths == Maths::native ? kAgree : kDiffer;
  }

  /// The scene that was named, or the plain world, which most functions don't read.
  probe::World replayWorld(const RenderOptions& options) const {
    if (scene_.empty()) {
      probe::World world = probe::plainWorld();
      world.options.maths = options.maths;
      return world;
    }
    const Scene scene = openScene(console_, scene_);
    const RenderOptions own = layOptions(scene.render, given_);
    checkOptions(own);
    return probe::sceneWorld(*flattenScene(scene, own), own);
  }

  Json toJson(const Context& context, const RenderOptions& options,
              const std::vector<FunctionTrial>& trials) const {
    Json json = {{"maths", options.maths == Maths::strict ? "strict" : "native"},
                 {"samples", samples_},
                 {"seed", options.seed},
                 {"renderer", context.renderer()},
                 {"functions", Json::array()},
                 {"provenance", machineJson()}};
    for (const FunctionTrial& trial : trials) json["functions"].push_back(trialJson(trial));
    return json;
  }

  static std::string summary(const std::vector<FunctionTrial>& trials, std::ptrdiff_t differing,
                             const Context& context) {
    const auto count = [&](probe::Verdict verdict) {
      return std::ranges::count(trials, verdict, &FunctionTrial::verdict);
    };
    return fmt::format(
        "\n{}: {} functions identical, {} differ, {} without a twin{}\n", context.renderer(),
        count(probe::Verdict::identical), differing, count(probe::Verdict::noTwin),
        count(probe::Verdict::notInNative) == 0
            ? ""
            : fmt::format(", {} not in native maths", count(probe::Verdict::notInNative)));
  }

  Console console_;
  std::vector<std::string> names_;
  std::size_t samples_ = 100000;
  std::optional<std::string> inputs_;
  bool statements_ = false;
  std::string scene_;
  std::string shader_;
  probe::UserTrialSettings user_;
  GivenOptions given_;
  AnswerOptions answer_;
};

}  // namespace

Command addProbeCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<ProbeCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
