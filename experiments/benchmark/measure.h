#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene/scene.h"
#include "experiments/benchmark/arms.h"

namespace twintrace {

/// How a scene is measured.
struct MeasurePlan {
  int repeats = 7;
  int frames = 0;  ///< per repeat; 0 = as many as fill `repeatSeconds`
  double repeatSeconds = 0.7;
  std::uint32_t seed = 1;  ///< of the order of arms
};

/// Times of one arm, per repeat of `frames` frames.
struct ArmTimes {
  std::string arm;
  std::string missing;  ///< why it could not run; then the rest is empty
  int frames = 0;
  double samplesPerRepeat = 0;
  std::vector<double> wallSeconds;  ///< of sampling, read-back left out
  std::vector<double> cpuSeconds;   ///< of the whole process

  bool measured() const { return !wallSeconds.empty(); }
};

/// The arms' times on one scene.
struct SceneTimes {
  std::string scene;
  int threads = 0;
  std::vector<ArmTimes> arms;

  /// The arm of that name, or nullptr if it is none or could not run.
  const ArmTimes* find(std::string_view name) const;
};

/// Which clock a rate is read from.
enum class Clock { wall, cpu };

/// Millions of samples per second in the fastest repeat. By the process's CPU time it is what
/// `threads` undisturbed processors would do, which other programs disturb less.
double bestRate(const ArmTimes& times, Clock clock, int threads);

/// Called before each repeat with its number from 0, for progress.
using RepeatListener = std::function<void(int repeat)>;

/// Runs every arm `repeats` times on one scene, in a new random order in each repeat, so that slow
/// moments of the machine hit all arms alike. Each arm renders one untimed frame first.
SceneTimes measureScene(const Scene& scene, const std::vector<BenchmarkArm>& arms,
                        const MeasurePlan& plan, const RepeatListener& onRepeat);

}  // namespace twintrace
