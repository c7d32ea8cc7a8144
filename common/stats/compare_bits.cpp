#include "common/stats/compare_bits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "common/base/float_bits.h"
#include "common/stats/image_estimate.h"

namespace twintrace {
namespace {

std::uint32_t pixelUlp(const Image& a, const Image& b, std::size_t pixel) {
  std::uint32_t ulp = 0;
  for (std::size_t i = pixel * 3; i < pixel * 3 + 3; ++i)
    ulp = std::max(ulp, ulpDistance(a.rgb[i], b.rgb[i]));
  return ulp;
}

std::array<double, 3> finiteMeans(const Image& image) {
  std::array<double, 3> sums{};
  std::array<std::int64_t, 3> counts{};
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    if (!std::isfinite(image.rgb[i])) continue;
    sums[i % 3] += image.rgb[i];
    ++counts[i % 3];
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    sums[channel] = counts[channel] > 0 ? sums[channel] / static_cast<double>(counts[channel])
                                        : std::numeric_limits<double>::quiet_NaN();
  }
  return sums;
}

void addErrors(BitComparison& result, const Image& a, const Image& b) {
  double squares = 0.0;
  double relativeSquares = 0.0;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    if (!std::isfinite(a.rgb[i]) || !std::isfinite(b.rgb[i])) {
      ++result.nonFiniteValues;
      continue;
    }
    const double reference = b.rgb[i];
    const double difference = a.rgb[i] - reference;
    squares += difference * difference;
    relativeSquares += difference * difference / (reference * reference + 0.01);
    ++count;
  }
  if (count == 0) return;
  result.rmse = std::sqrt(squares / static_cast<double>(count));
  result.relmse = relativeSquares / static_cast<double>(count);
}

}  // namespace

BitComparison compareBits(const Image& a, const Image& b) {
  requireSameSize(a, b);
  BitComparison result;
  result.pixels = static_cast<std::int64_t>(a.pixelCount());
  for (std::size_t pixel = 0; pixel < a.pixelCount(); ++pixel) {
    for (std::size_t i = pixel * 3; i < pixel * 3 + 3; ++i) {
      ++result.ulpHistogram[static_cast<std::size_t>(
          std::bit_width(ulpDistance(a.rgb[i], b.rgb[i])))];
    }
    const std::uint32_t ulp = pixelUlp(a, b, pixel);
    result.maxUlp = std::max(result.maxUlp, ulp);
    if (ulp == 0) continue;
    const int index = static_cast<int>(pixel);
    if (!result.first) result.first = PixelPosition{index % a.width, index / a.width};
    ++result.differingPixels;
  }
  addErrors(result, a, b);
  result.meanA = finiteMeans(a);
  result.meanB = finiteMeans(b);
  return result;
}

std::vector<float> ulpMap(const Image& a, const Image& b) {
  requireSameSize(a, b);
  std::vector<float> map(a.pixelCount());
  for (std::size_t pixel = 0; pixel < map.size(); ++pixel) {
    map[pixel] = static_cast<float>(pixelUlp(a, b, pixel));
  }
  return map;
}

}  // namespace twintrace
