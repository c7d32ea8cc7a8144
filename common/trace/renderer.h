#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/trace/options.h"

namespace twintrace {

/// Facts about the machine and program behind a renderer, for provenance: never part of what
/// determines the bits of a picture.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// One back end, ready to render one flat scene with fixed options.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Renders one frame: for each pixel the sum, in sample order and in float, of the samples
  /// firstSample .. firstSample + passes - 1.
  /// @param sums width * height * 3 floats (R, G, B), row 0 on top; overwritten.
  /// @return seconds of wall time spent on sampling, without transfer of results.
  /// @throws DeviceError if the device fails.
  virtual double renderFrame(std::uint32_t firstSample, int passes, std::span<float> sums) = 0;

  /// What ran: lanes or renderer string, program facts.
  virtual Provenance provenance() const = 0;
};

}  // namespace twintrace
