#pragma once

#include <array>
#include <string>
#include <vector>

#include "experiments/arm.h"
#include "experiments/explain/explanation.h"

namespace twintrace {

/// The radiance of a sample as the arms render it, without any tracing.
struct PlainSample {
  std::array<float, 3> a{};
  std::array<float, 3> b{};

  bool differs() const;
};

/// Renders one sample of all pixels on both arms. @throws DeviceError if a device fails.
PlainSample renderPlainSample(Arm& a, Arm& b, const PixelPosition& pixel, std::int64_t sample);

/// In words: where the traced programs give other bits than the plain ones, and whether they still
/// show the difference. In native maths, where a driver may compile the traced text differently,
/// also that they give the same, if so.
std::vector<std::string> traceNotes(const PlainSample& plain, const SampleExplanation& explanation,
                                    bool native);

}  // namespace twintrace
