#include "experiments/render_job.h"

#include <algorithm>

namespace twintrace {

double doneFraction(const ArmRun& run, const RenderOptions& options) {
  const double byFrames = double(run.framesDone()) / double(plannedFrames(options));
  const double byTime = options.timeLimit > 0 ? run.seconds() / options.timeLimit : 0.0;
  // The error falls with the root of the samples.
  const double errorRatio = options.targetError / run.relativeError();
  return std::min(1.0, std::max({byFrames, byTime, errorRatio * errorRatio}));
}

RenderResult renderFilm(Arm& arm, const JobControl& control) {
  ArmRun run(arm);
  run.warmUp();
  const std::int64_t samplesPerFrame =
      std::int64_t{arm.options.width} * arm.options.height * arm.options.passes;
  std::optional<StopReason> stop;
  while (!stop) {
    run.renderNext();
    control.report(
        {doneFraction(run, arm.options), run.framesDone() * samplesPerFrame, run.seconds()});
    stop = run.stopRule();
    if (!stop && control.stopRequested()) stop = StopReason::interrupt;
  }
  const double seconds = run.seconds();
  return {run.takeFilm(), seconds, *stop};
}

}  // namespace twintrace
