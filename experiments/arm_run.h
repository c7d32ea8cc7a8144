#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "common/film/film.h"
#include "experiments/arm.h"

namespace twintrace {

/// Why a run ended.
enum class StopReason { samples, time, targetError, interrupt };

/// The reason as written in JSON: samples, time, target-error or interrupt.
std::string_view stopReasonName(StopReason reason);

/// Frames that the options ask for, as many as a film holds at most.
std::int64_t plannedFrames(const RenderOptions& options);

/// The frames of one arm, rendered one after the other into a film. The arm has to outlive the run.
class ArmRun {
 public:
  explicit ArmRun(Arm& arm);

  /// Renders one sample that is thrown away: compilation, first-touched pages and the start of
  /// threads stay out of the time.
  void warmUp();

  /// Renders the next frame and adds it to the film.
  /// @return the frame's sums, valid until the next call.
  std::span<const float> renderNext();

  /// The stop rule that holds after the frames so far, or nothing.
  std::optional<StopReason> stopRule() const;

  std::int64_t framesDone() const { return framesDone_; }
  double seconds() const { return seconds_; }  ///< spent on sampling, without the warm-up
  /// Relative standard error so far; infinite if the options bound none.
  double relativeError() const { return relativeError_; }
  const Film& film() const { return film_; }
  Film takeFilm() { return std::move(film_); }

 private:
  Arm& arm_;
  Film film_;
  std::vector<float> sums_;
  std::int64_t framesDone_ = 0;
  double seconds_ = 0;
  double relativeError_ = std::numeric_limits<double>::infinity();
};

}  // namespace twintrace
