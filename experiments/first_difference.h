#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "experiments/arm.h"
#include "experiments/comparison.h"
#include "experiments/job_control.h"

namespace twintrace {

/// Remembers for each pixel the first frame in which two paired arms differ.
class FrameDifferences {
 public:
  FrameDifferences(int width, int height);

  /// Adds the next frame of both arms.
  void add(std::span<const float> a, std::span<const float> b);

  /// Index of the first frame that differs at a pixel, if any does.
  std::optional<std::uint32_t> firstFrame(const PixelPosition& pixel) const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  int width_;
  std::uint32_t frameCount_ = 0;
  std::vector<std::uint32_t> firstFrame_;
};

/// Finds the first sample that differs at a pixel within the first frame whose sums differ there,
/// by rendering its samples one by one; at most kMaxPasses of them. Earlier differences that
/// rounding of a frame's sum swallowed changed no film and are not looked for. Without a frame, or
/// if the user interrupts, the sample stays unknown.
FirstDifference locateDifference(const PixelPosition& pixel, const Image& a, const Image& b,
                                 Arm& armA, Arm& armB, std::optional<std::uint32_t> frame,
                                 const JobControl& control);

}  // namespace twintrace
