// Plants faults of one ulp in random functions of the GLSL path tracer, one at a time, and asks
// explain where they are. A fault counts if a plain rendering shows it in at least one pixel;
// others are absorbed and replaced. Then the located call is run alone, as `probe --statements`
// does it, and asked which statement is at fault. Usage: twintrace_audit [COUNT] [SEED]; 50 faults
// unless said. Exits with 1 unless each is located to the function that has it, and to the
// statement.

#include <cstdio>
#include <cstdlib>
#include <random>

#include "common/base/float_bits.h"
#include "experiments/arm.h"
#include "experiments/probe/statement_replay.h"
#include "experiments/probe/trial.h"
#include "gpu/provider.h"
#include "gpu/specialisation.h"
#include "tests/audit/faults.h"

namespace twintrace::test {
namespace {

constexpr int kMostTries = 500;
constexpr std::uint32_t kSamples = 4;

/// Where the tools say that a fault is.
struct Finding {
  std::string function;
  std::string place;  ///< `file:line` of the statement
};

/// A scene as the CPU sees it, which no fault reaches.
class FaultyScene {
 public:
  explicit FaultyScene(const std::string& name)
      : name_(name),
        scene_(name),
        cpu_(scene_.cpu(TraceDetail::calls)),
        sound_(render(scene_.options)),
        context_(createContext(scene_.options.provider, scene_.options.threads)) {
    for (const FunctionFaults& f : possibleFaults(calledFunctions())) faults_.push_back(f);
  }

  const std::string& name() const { return name_; }

  /// Faults in the functions that samples of this scene call.
  const std::vector<FunctionFaults>& faults() const { return faults_; }

  /// The pixels whose sums differ when both tracers render, one of them with the fault.
  std::vector<PixelPosition> changedPixels(const FaultPlace& fault) const {
    RenderOptions options = scene_.options;
    options.backend = BackEnd::gpu;
    options.shaderOverrides = {fault.shader};
    const std::vector<float> sums = render(options);
    std::vector<PixelPosition> changed;
    for (std::size_t i = 0; i < sums.size(); i += 3) {
      bool same = true;
      for (std::size_t c = i; c < i + 3; ++c) same = same && sameBits(sums[c], sound_[c]);
      const int pixel = static_cast<int>(i / 3);
      if (!same) changed.push_back({pixel % options.width, pixel / options.width});
    }
    return changed;
  }

  /// The function that explain names for a pixel, and the statement that probe names in it.
  Finding located(const FaultPlace& fault, const PixelPosition& pixel) const {
    const auto gpu = scene_.gpu({fault.shader}, TraceDetail::calls);
    for (std::uint32_t sample = 0; sample < kSamples; ++sample) {
      SampleExplanation result;
      explainSample(*cpu_, *gpu, pixel, sample, result);
      if (!result.sameRadiance) return {culprit(result), statement(fault, result)};
    }
    return {"no sample", ""};
  }

 private:
  std::string statement(const FaultPlace& fault, const SampleExplanation& explained) const {
    if (!explained.divergence) return "none";
    const CallTree& tree = explained.treeA;
    const Call& call = tree.calls[static_cast<std::size_t>(explained.divergence->a)];
    const auto& function = tree.program->functions[static_cast<std::size_t>(call.function)];
    RenderOptions options = scene_.options;
    options.shaderOverrides = {fault.shader};
    std::vector<std::uint32_t> inputs(call.inputs.words.begin(), call.inputs.words.end());
    if (inputs.empty()) inputs.push_back(0);  // as parseInputs() has it
    probe::StatementReplay replay;
    replayStatements(*context_, shaderLibrary(options),
                     *probe::chooseFunctions({signatureOf(function)}).front(),
                     probe::sceneWorld(*scene_.flat, options), inputs, replay);
    if (!replay.divergence) return "none";
    return replay.divergence->statement.a.site->place;
  }

  std::vector<float> render(const RenderOptions& options) const {
    const Arm arm = openArm(scene_.scene, options);
    std::vector<float> sums(static_cast<std::size_t>(options.width * options.height) * 3);
    arm.renderer->renderFrame(0, kSamples, sums);
    return sums;
  }

  std::set<std::string> calledFunctions() const {
    std::set<std::string> names;
    for (int at = 0; at < scene_.options.width * scene_.options.height; ++at) {
      const PixelPosition pixel{at % scene_.options.width, at / scene_.options.width};
      const CallTrace trace = cpu_->trace(pixel, 0);
      const CallTree tree = buildCallTree(cpu_->program(), trace);
      for (std::size_t i = 0; i < tree.calls.size(); ++i) {
        names.emplace(tree.name(static_cast<int>(i)));
      }
    }
    return names;
  }

  std::string name_;
  SmallScene scene_;
  std::unique_ptr<PathTracer> cpu_;
  std::vector<float> sound_;
  std::unique_ptr<Context> context_;
  std::vector<FunctionFaults> faults_;
};

struct Tally {
  std::set<std::string> tried;  ///< what the rows say of their faults; none is planted twice
  int shown = 0;
  int located = 0;
  int named = 0;
  int absorbed = 0;
};

/// Plants one fault and prints its row.
void tryFault(const FaultyScene& scene, const FaultPlace& fault, Tally& tally) {
  const std::string about =
      fault.function + fault.word + " (" + fault.file + ", " + scene.name() + ")";
  if (!tally.tried.insert(about).second) return;
  const std::vector<PixelPosition> changed = scene.changedPixels(fault);
  if (changed.empty()) {
    ++tally.absorbed;
    return;
  }
  ++tally.shown;
  const Finding found = scene.located(fault, changed[changed.size() / 2]);
  const bool located = found.function == fault.function;
  const bool named = found.place == fault.place;
  tally.located += located ? 1 : 0;
  tally.named += named ? 1 : 0;
  std::printf("%-72s | %4zu | %s%s | %s%s\n", about.c_str(), changed.size(), found.function.c_str(),
              located ? "" : "  WRONG", found.place.c_str(), named ? "" : "  WRONG");
  std::fflush(stdout);
}

int audit(int wanted, unsigned seed) {
  const FaultyScene scenes[] = {FaultyScene("cornell.toml"), FaultyScene("local-lights.toml"),
                                FaultyScene("roughness-row.toml"), FaultyScene("open.toml")};
  std::mt19937 random(seed);
  Tally tally;
  std::printf("%-72s | %s | %s | %s\n", "fault: one ulp in (16x16 pixels, 4 samples)",
              "pixels changed", "explain points to", "probe points to");
  for (int i = 0; i < kMostTries && tally.shown < wanted; ++i) {
    const FaultyScene& scene = scenes[random() % std::size(scenes)];
    const FunctionFaults& faults = scene.faults()[random() % scene.faults().size()];
    tryFault(scene, faults[random() % faults.size()], tally);
  }
  std::printf("%d of %d faults located; %d more changed no pixel\n", tally.located, tally.shown,
              tally.absorbed);
  std::printf("statement named: %d of %d\n", tally.named, tally.shown);
  const bool all = tally.located == tally.shown && tally.named == tally.shown;
  return tally.shown == wanted && all ? 0 : 1;
}

}  // namespace
}  // namespace twintrace::test

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 50;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  return twintrace::test::audit(count, seed);
}
