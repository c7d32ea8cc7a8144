#pragma once

#include "common/scene/scene.h"
#include "experiments/arm.h"
#include "experiments/arm_run.h"
#include "experiments/comparison.h"
#include "experiments/first_difference.h"
#include "experiments/job_control.h"

namespace twintrace {

/// The options of both sides of a comparison.
struct ArmOptions {
  RenderOptions a;
  RenderOptions b;
};

/// Sample range as a whole number of frames, passes, seed and noise are equal: the arms draw the
/// same samples and their bits decide. Unequal passes round sums of the same samples differently.
bool isPaired(const ArmOptions& options);

/// Makes unpaired arms fit for the tests, which need 32 batches each: lowers passes where they make
/// fewer frames, and raises spp below 32. Paired arms are left as they are.
/// @return what was changed, and that nothing but passes makes the arms unpaired, in words.
std::vector<std::string> fitForTests(ArmOptions& options);

/// @throws UsageError unless both films have the same size, which the message gives.
void checkArms(const ArmOptions& options);

struct ArmOutcome {
  Film film;
  std::vector<double> seconds;  ///< of each timed run, without warm-up; the first made the film
  StopReason stoppedBy = StopReason::samples;

  double bestSeconds() const;
};

struct ArmsComparison {
  Comparison comparison;
  ArmOutcome a;
  ArmOutcome b;
  std::optional<FrameDifferences> differences = std::nullopt;  ///< of paired arms
};

/// Renders two arms frame by frame in turns and compares them. A paired run ends for both arms as
/// soon as a stop rule holds for one, so that their samples stay the same; unpaired arms end each
/// by its own rule, but not before their batches are complete. An interrupt ends the run after the
/// frames under way; what can't be judged then is inconclusive.
/// @param paired isPaired() of the arms as the user put them, before fitForTests().
ArmsComparison compareArms(Arm& a, Arm& b, bool paired, const ComparisonSettings& settings,
                           const JobControl& control);

}  // namespace twintrace
