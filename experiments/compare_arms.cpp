#include "experiments/compare_arms.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/base/error.h"
#include "experiments/batch_builder.h"
#include "experiments/first_difference.h"
#include "experiments/render_job.h"

namespace twintrace {
namespace {

constexpr int kFewestFrames = static_cast<int>(BatchBuilder::kFewest);

std::int64_t samplesOf(const RenderOptions& options) {
  return plannedFrames(options) * options.passes;
}

bool drawFromSameSequence(const RenderOptions& a, const RenderOptions& b) {
  return a.seed == b.seed && a.noise == b.noise && a.firstSample == b.firstSample;
}

void fitArm(RenderOptions& options, const char* name, std::vector<std::string>& notes) {
  if (plannedFrames(options) >= kFewestFrames) return;
  if (options.spp < kFewestFrames) {
    notes.push_back(
        fmt::format("{}: {} samples per pixel instead of {}, since unpaired arms need "
                    "{} batches",
                    name, kFewestFrames, options.spp, kFewestFrames));
    options.spp = kFewestFrames;
  }
  int passes = options.spp / kFewestFrames;
  while (options.firstSample % passes != 0) --passes;
  if (passes < options.passes) {
    notes.push_back(
        fmt::format("{}: {} samples per frame instead of {}, since unpaired arms need "
                    "{} batches",
                    name, passes, options.passes, kFewestFrames));
    options.passes = passes;
  }
}

/// One arm of an unpaired comparison.
class UnpairedRun {
 public:
  explicit UnpairedRun(Arm& arm)
      : run_(arm), passes_(arm.options.passes), batches_(arm.options.width, arm.options.height) {}

  void step() {
    batches_.addFrame(run_.renderNext(), passes_);
    if (batches_.complete()) stop_ = run_.stopRule();
  }
  const std::optional<StopReason>& stop() const { return stop_; }
  ArmRun& run() { return run_; }
  const BatchBuilder& batches() const { return batches_; }

 private:
  ArmRun run_;
  int passes_;
  BatchBuilder batches_;
  std::optional<StopReason> stop_;
};

class Comparer {
 public:
  Comparer(Arm& a, Arm& b, bool paired, const ComparisonSettings& settings,
           const JobControl& control)
      : a_(a), b_(b), paired_(paired), settings_(settings), control_(control) {}

  ArmsComparison run() {
    ArmsComparison result = paired_ ? runPaired() : runUnpaired();
    noteBadFrames(result.comparison, "a", result.a.film);
    noteBadFrames(result.comparison, "b", result.b.film);
    result.comparison.family.alpha = settings_.alpha;
    result.comparison.equivalence.bound = settings_.bound;
    repeat(result);
    return result;
  }

 private:
  ArmsComparison runPaired() {
    ArmRun runA(a_);
    ArmRun runB(b_);
    FrameDifferences differences(a_.options.width, a_.options.height);
    runA.warmUp();
    runB.warmUp();
    std::optional<StopReason> stop;
    while (!stop) {
      const auto sumsA = runA.renderNext();
      differences.add(sumsA, runB.renderNext());
      report(runA, runB);
      stop = pairedStop(runA, runB);
    }
    ArmsComparison result = gather(runA, *stop, runB, *stop);
    judgePaired(result, differences);
    result.differences = std::move(differences);
    return result;
  }

  std::optional<StopReason> pairedStop(const ArmRun& runA, const ArmRun& runB) const {
    if (const auto stop = runA.stopRule()) return stop;
    if (const auto stop = runB.stopRule()) return stop;
    return interruption();
  }

  ArmsComparison runUnpaired() {
    UnpairedRun runA(a_);
    UnpairedRun runB(b_);
    runA.run().warmUp();
    runB.run().warmUp();
    std::optional<StopReason> stop;
    while (!stop && !(runA.stop() && runB.stop())) {
      if (!runA.stop()) runA.step();
      if (!runB.stop()) runB.step();
      report(runA.run(), runB.run());
      stop = interruption();
    }
    ArmsComparison result = gather(runA.run(), runA.stop().value_or(StopReason::interrupt),
                                   runB.run(), runB.stop().value_or(StopReason::interrupt));
    judgeUnpaired(result.comparison, runA.batches(), runB.batches());
    return result;
  }

  std::optional<StopReason> interruption() const {
    if (control_.stopRequested()) return StopReason::interrupt;
    return std::nullopt;
  }

  void report(const ArmRun& runA, const ArmRun& runB) const {
    const auto samples = [](const ArmRun& run, const RenderOptions& options) {
      return run.framesDone() * options.passes * options.width * options.height;
    };
    const double doneA = doneFraction(runA, a_.options);
    const double doneB = doneFraction(runB, b_.options);
    const double done = paired_ ? std::max(doneA, doneB) : 0.5 * (doneA + doneB);
    control_.report({done / settings_.repeats,
                     samples(runA, a_.options) + samples(runB, b_.options),
                     runA.seconds() + runB.seconds()});
  }

  static ArmsComparison gather(ArmRun& runA, StopReason stopA, ArmRun& runB, StopReason stopB) {
    Comparison comparison = comparePictures(exrContent(runA.film()), exrContent(runB.film()));
    addZMap(comparison, estimateFrom(comparison.a, "a"), estimateFrom(comparison.b, "b"));
    const double secondsA = runA.seconds();
    const double secondsB = runB.seconds();
    return {std::move(comparison),
            {runA.takeFilm(), {secondsA}, stopA},
            {runB.takeFilm(), {secondsB}, stopB}};
  }

  void judgePaired(ArmsComparison& result, const FrameDifferences& differences) const {
    Comparison& comparison = result.comparison;
    const FilmDifference difference = compareFilms(result.a.film, result.b.film);
    comparison.paired = true;
    comparison.differingPixels = difference.differingPixels;
    comparison.verdict = pairedVerdict(difference.differingPixels);
    if (!difference.first) {
      comparison.first.reset();
      return;
    }
    comparison.first =
        locateDifference(*difference.first, comparison.a.image, comparison.b.image, a_, b_,
                         differences.firstFrame(*difference.first), control_);
  }

  void judgeUnpaired(Comparison& comparison, const BatchBuilder& runA,
                     const BatchBuilder& runB) const {
    const BatchMeans& a = runA.means();
    const BatchMeans& b = runB.means();
    comparison.droppedFrames = runA.droppedFrames() + runB.droppedFrames();
    if (a_.options.seed == b_.options.seed && a_.options.noise == b_.options.noise) {
      comparison.notes.push_back(kSharedSeedNote);
    }
    if (a.batchCount() < kMinBatchCount || b.batchCount() < kMinBatchCount) {
      comparison.notes.push_back(
          fmt::format("interrupted after {} and {} batches; the tests need {}: inconclusive",
                      a.batchCount(), b.batchCount(), kMinBatchCount));
      return;
    }
    comparison.family = familyTest(a, b, settings_.alpha);
    comparison.equivalence =
        equivalenceTest(channelMeans(a), channelMeans(b), settings_.bound, settings_.alpha);
    comparison.verdict = unpairedVerdict(comparison.family, comparison.equivalence);
  }

  static void noteBadFrames(Comparison& comparison, const char* arm, const Film& film) {
    if (film.badFrameCount() == 0) return;
    comparison.notes.push_back(
        fmt::format("{}: {} frames of pixels were not finite or too large and are left out", arm,
                    film.badFrameCount()));
  }

  /// The other timed runs, of as many frames as the first: only their times are kept.
  void repeat(ArmsComparison& result) const {
    for (int i = 1; i < settings_.repeats && !control_.stopRequested(); ++i) {
      timeAgain(a_, result.a);
      timeAgain(b_, result.b);
      control_.report({double(i + 1) / settings_.repeats, 0, 0});
    }
  }

  void timeAgain(Arm& arm, ArmOutcome& outcome) const {
    const RenderOptions& options = arm.options;
    std::vector<float> sums(outcome.film.data().pixels.size() * 3);
    double seconds = 0;
    for (std::int64_t frame = 0; frame < std::int64_t{outcome.film.frameCount()}; ++frame) {
      const auto first = static_cast<std::uint32_t>(options.firstSample + frame * options.passes);
      seconds += arm.renderer->renderFrame(first, options.passes, sums);
      if (control_.stopRequested()) return;
    }
    outcome.seconds.push_back(seconds);
  }

  Arm& a_;
  Arm& b_;
  bool paired_;
  const ComparisonSettings& settings_;
  const JobControl& control_;
};

}  // namespace

bool isPaired(const ArmOptions& options) {
  const RenderOptions& a = options.a;
  const RenderOptions& b = options.b;
  return drawFromSameSequence(a, b) && a.passes == b.passes && samplesOf(a) == samplesOf(b);
}

std::vector<std::string> fitForTests(ArmOptions& options) {
  std::vector<std::string> notes;
  if (isPaired(options)) return notes;
  if (options.a.passes != options.b.passes && drawFromSameSequence(options.a, options.b)) {
    notes.push_back(
        fmt::format("passes differ ({} and {}): frames are summed differently, so the arms are "
                    "tested as unpaired",
                    options.a.passes, options.b.passes));
  }
  fitArm(options.a, "a", notes);
  fitArm(options.b, "b", notes);
  return notes;
}

void checkArms(const ArmOptions& options) {
  const RenderOptions& a = options.a;
  const RenderOptions& b = options.b;
  if (a.width == b.width && a.height == b.height) return;
  throw UsageError(fmt::format("found arms of {}x{} and {}x{} pixels, expected equal sizes",
                               a.width, a.height, b.width, b.height));
}

double ArmOutcome::bestSeconds() const {
  return *std::min_element(seconds.begin(), seconds.end());
}

ArmsComparison compareArms(Arm& a, Arm& b, bool paired, const ComparisonSettings& settings,
                           const JobControl& control) {
  return Comparer(a, b, paired, settings, control).run();
}

}  // namespace twintrace
