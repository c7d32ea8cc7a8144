#pragma once

#include "experiments/arm_run.h"
#include "experiments/job_control.h"

namespace twintrace {

struct RenderResult {
  Film film;
  double seconds = 0;  ///< of sampling, after one untimed frame
  StopReason stoppedBy = StopReason::samples;

  std::uint64_t samplesPerPixel() const { return film.data().ranges.sampleCount(); }
};

/// Renders an arm until its samples are done, a stop rule holds or the user interrupts, but at
/// least one frame.
RenderResult renderFilm(Arm& arm, const JobControl& control);

/// Share of a run that is done, by frames, time or target error, whichever is furthest.
double doneFraction(const ArmRun& run, const RenderOptions& options);

}  // namespace twintrace
