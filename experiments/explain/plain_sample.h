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

/// In words: what the traced programs show otherwise than the plain ones, whether they still show
/// the difference, and in native maths, where a driver may compile the traced text otherwise, also
/// that they are true.
std::vector<std::string> traceNotes(const PlainSample& plain, const SampleExplanation& explanation,
                                    bool native);

}  // namespace twintrace
