#include "experiments/benchmark/measure.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "common/base/error.h"
#include "experiments/arm.h"
#include "gpu/tracer.h"

namespace twintrace {
namespace {

constexpr int kMinFrames = 2;
constexpr int kMaxFrames = 1000;  // of an arm whose trial frame was too short to measure

double processSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) { return time.tv_sec + 1e-6 * time.tv_usec; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::unique_ptr<Renderer> openRenderer(const Scene& scene, const BenchmarkArm& arm) {
  const std::shared_ptr<const FlatScene> flat = flattenScene(scene, arm.options);
  if (arm.options.backend == BackEnd::gpu) return makeGpuRenderer(flat, arm.options);
  CpuTracerSettings settings;
  settings.instructionSet = arm.instructionSet;
  return makeCpuRenderer(flat, arm.options, settings);
}

/// An arm with its renderer, and the times so far.
class Runner {
 public:
  Runner(const Scene& scene, const BenchmarkArm& arm, const MeasurePlan& plan)
      : options_(arm.options), sums_(std::size_t(3) * arm.options.width * arm.options.height) {
    times_.arm = arm.name;
    try {
      renderer_ = openRenderer(scene, arm);
      renderFrame(0);
    } catch (const DeviceError& error) {
      times_.missing = error.what();
      return;
    }
    times_.frames = plan.frames > 0 ? plan.frames : framesFor(plan.repeatSeconds);
    times_.samplesPerRepeat =
        double(options_.width) * options_.height * options_.passes * times_.frames;
  }

  bool missing() const { return !times_.missing.empty(); }

  /// The same samples in every repeat, so that minima are of the same work.
  void runOnce() {
    const double cpuBefore = processSeconds();
    double wall = 0;
    for (int frame = 0; frame < times_.frames; ++frame) wall += renderFrame(frame);
    times_.wallSeconds.push_back(wall);
    times_.cpuSeconds.push_back(processSeconds() - cpuBefore);
  }

  const ArmTimes& times() const { return times_; }

 private:
  int framesFor(double seconds) {
    const double frames = std::ceil(seconds / std::max(renderFrame(1), 1e-9));
    return static_cast<int>(std::clamp<double>(frames, kMinFrames, kMaxFrames));
  }

  double renderFrame(int frame) {
    return renderer_->renderFrame(static_cast<std::uint32_t>(frame * options_.passes),
                                  options_.passes, sums_);
  }

  RenderOptions options_;
  std::vector<float> sums_;
  std::unique_ptr<Renderer> renderer_;
  ArmTimes times_;
};

}  // namespace

const ArmTimes* SceneTimes::find(std::string_view name) const {
  const auto found = std::find_if(arms.begin(), arms.end(), [name](const ArmTimes& times) {
    return times.arm == name && times.measured();
  });
  return found == arms.end() ? nullptr : &*found;
}

double bestRate(const ArmTimes& times, Clock clock, int threads) {
  const std::vector<double>& seconds = clock == Clock::wall ? times.wallSeconds : times.cpuSeconds;
  const double best = *std::min_element(seconds.begin(), seconds.end());
  const double share = clock == Clock::wall ? 1.0 : threads;
  return 1e-6 * times.samplesPerRepeat * share / best;
}

SceneTimes measureScene(const Scene& scene, const std::vector<BenchmarkArm>& arms,
                        const MeasurePlan& plan, const RepeatListener& onRepeat) {
  std::vector<Runner> runners;
  for (const BenchmarkArm& arm : arms) runners.emplace_back(scene, arm, plan);
  std::vector<Runner*> order;
  for (Runner& runner : runners) {
    if (!runner.missing()) order.push_back(&runner);
  }
  std::mt19937 random(plan.seed);
  for (int repeat = 0; repeat < plan.repeats; ++repeat) {
    onRepeat(repeat);
    std::shuffle(order.begin(), order.end(), random);
    for (Runner* runner : order) runner->runOnce();
  }
  SceneTimes result{scene.name, arms.front().options.threads, {}};
  for (const Runner& runner : runners) result.arms.push_back(runner.times());
  return result;
}

}  // namespace twintrace
