#pragma once

#include "experiments/arm.h"
#include "experiments/compare_arms.h"

namespace twintrace {

/// How many differing pixels a comparison examines at most.
inline constexpr int kMostExplained = 64;

/// For how many seconds it goes on examining; a pixel under way is finished.
inline constexpr double kExplainSeconds = 10;

/// Explains differing pixels of paired arms, spread over the picture, and fills `classes` and
/// `divergeBounce` of the comparison. In each pixel the first sample that differs counts; a pixel of
/// which no traced sample differs is unexplained.
/// @throws DeviceError as openArm.
void addDifferenceClasses(ArmsComparison& result, const Arm& a, const Arm& b,
                          const JobControl& control);

}  // namespace twintrace
