#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>

#include "experiments/job_control.h"

namespace twintrace {

/// Shows how far a job is: a bar on a terminal, else a plain line now and then.
class ProgressDisplay {
 public:
  enum class Style { none, lines, bar };

  /// The style for standard error: none if quiet, a bar if it is a terminal.
  static Style styleForStandardError(bool quiet);

  ProgressDisplay(std::ostream& stream, Style style);
  /// Wipes the bar.
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Shows the state, unless the last one was shown too short a time ago.
  void show(const JobProgress& state);

 private:
  using Clock = std::chrono::steady_clock;
  std::ostream& stream_;
  Style style_;
  Clock::time_point start_;
  Clock::time_point lastShown_;
  bool barShown_ = false;
};

/// `42 %, 12.3 M samples/s, 1:05 left`; the rate is left out while it is not known.
std::string progressText(const JobProgress& state, double elapsedSeconds);

/// `12.3 M` for 12.3e6, and so on.
std::string shortNumber(double value);

}  // namespace twintrace
