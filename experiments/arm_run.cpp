#include "experiments/arm_run.h"

#include <algorithm>

namespace twintrace {

std::string_view stopReasonName(StopReason reason) {
  switch (reason) {
    case StopReason::time:
      return "time";
    case StopReason::targetError:
      return "target-error";
    case StopReason::interrupt:
      return "interrupt";
    case StopReason::samples:
      break;
  }
  return "samples";
}

std::int64_t plannedFrames(const RenderOptions& options) {
  return std::min<std::int64_t>(options.frameCount(), kMaxFrames);
}

ArmRun::ArmRun(Arm& arm)
    : arm_(arm),
      film_(arm.options.width, arm.options.height, arm.metadata),
      sums_(film_.data().pixels.size() * 3) {}

void ArmRun::warmUp() {
  arm_.renderer->renderFrame(static_cast<std::uint32_t>(arm_.options.firstSample), 1, sums_);
}

std::span<const float> ArmRun::renderNext() {
  const RenderOptions& options = arm_.options;
  const auto firstSample =
      static_cast<std::uint32_t>(options.firstSample + framesDone_ * options.passes);
  seconds_ += arm_.renderer->renderFrame(firstSample, options.passes, sums_);
  film_.addFrame(sums_, options.passes, firstSample);
  ++framesDone_;
  if (options.targetError > 0) relativeError_ = relativeStandardError(film_);
  return sums_;
}

std::optional<StopReason> ArmRun::stopRule() const {
  const RenderOptions& options = arm_.options;
  if (framesDone_ >= plannedFrames(options)) return StopReason::samples;
  if (options.timeLimit > 0 && seconds_ >= options.timeLimit) return StopReason::time;
  if (relativeError_ <= options.targetError) return StopReason::targetError;
  return std::nullopt;
}

}  // namespace twintrace
