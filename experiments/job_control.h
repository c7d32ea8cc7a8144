#pragma once

#include <cstdint>
#include <functional>

namespace twintrace {

/// How far a job is, told after every frame.
struct JobProgress {
  double fraction = 0;       ///< done, 0 to 1
  std::int64_t samples = 0;  ///< rendered so far, over all pixels and arms
  double seconds = 0;        ///< spent on sampling so far, over all arms
};

/// What ties a running job to its user; both functions may be empty.
struct JobControl {
  std::function<void(const JobProgress&)> progress;
  std::function<bool()> interrupted;  ///< asked after every frame

  void report(const JobProgress& state) const {
    if (progress) progress(state);
  }
  bool stopRequested() const { return interrupted && interrupted(); }
};

}  // namespace twintrace
