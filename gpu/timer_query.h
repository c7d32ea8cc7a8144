#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace twintrace {

class Context;

/// Measures the device's time for what is asked of it between start and stop, where the driver's
/// timer can be believed.
class TimerQuery {
 public:
  explicit TimerQuery(Context& context);
  ~TimerQuery();
  TimerQuery(const TimerQuery&) = delete;
  TimerQuery& operator=(const TimerQuery&) = delete;

  /// Waits for earlier work, so that it isn't counted, and starts the clocks.
  void start();

  /// Waits for the work since start() and stops the clocks.
  void stop();

  /// Seconds of wall time between start() and stop().
  double wallSeconds() const { return wallSeconds_; }

  /// The driver's seconds, or nothing where it has no timer or one that contradicts the wall clock:
  /// more than the wall time, or less than half of it although the device did all the work.
  std::optional<double> deviceSeconds() const;

 private:
  Context& context_;
  std::uint32_t query_ = 0;
  bool supported_ = false;
  std::chrono::steady_clock::time_point startTime_;
  double wallSeconds_ = 0;
  double queriedSeconds_ = 0;
};

}  // namespace twintrace
