#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/film/image.h"

namespace twintrace {

/// How two pictures of the same samples differ.
struct BitComparison {
  std::int64_t pixels = 0;
  std::int64_t differingPixels = 0;  ///< at least one channel with other bits
  std::uint32_t maxUlp = 0;          ///< 2^32 - 1 for a NaN against a number
  /// Channel values by distance: [0] equal, [k] 2^(k-1) <= ulp < 2^k.
  std::array<std::int64_t, 33> ulpHistogram{};
  std::optional<PixelPosition> first;  ///< first differing pixel in row order
  double rmse = 0.0;                   ///< root of the mean squared difference
  double relmse = 0.0;                 ///< mean of d^2 / (b^2 + 0.01), b as the reference
  std::array<double, 3> meanA{};       ///< per channel, over finite values; NaN without any
  std::array<double, 3> meanB{};
  /// Channel values left out of rmse and relmse, since at least one side is not finite.
  std::int64_t nonFiniteValues = 0;
};

/// Compares two pictures bit by bit; NaN equals NaN and -0 equals +0.
/// @throws UsageError if the sizes differ or the pictures are empty.
BitComparison compareBits(const Image& a, const Image& b);

/// Largest ULP distance of each pixel's channels, one value per pixel (rounded to float).
std::vector<float> ulpMap(const Image& a, const Image& b);

}  // namespace twintrace
