#include "experiments/comparison.h"

#include <fmt/format.h>

#include <limits>

#include "common/base/error.h"
#include "common/stats/z_map.h"

namespace twintrace {
namespace {

void checkFraction(const char* name, double value) {
  if (value > 0 && value < 1) return;
  throw UsageError(fmt::format("{}: found {}, expected a number between 0 and 1", name, value));
}

}  // namespace

void checkSettings(const ComparisonSettings& settings) {
  checkFraction("alpha", settings.alpha);
  checkFraction("bound", settings.bound);
  if (settings.repeats < 1) {
    throw UsageError(
        fmt::format("repeats: found {}, expected an integer from 1", settings.repeats));
  }
}

Comparison comparePictures(ExrContent a, ExrContent b) {
  Comparison result;
  result.bits = compareBits(a.image, b.image);
  result.differingPixels = result.bits.differingPixels;
  result.ulp = ulpMap(a.image, b.image);
  if (const auto pixel = result.bits.first) {
    const std::size_t index = pixelIndex(*pixel, a.image.width);
    result.first = {*pixel, std::nullopt, valueAt(a.image.rgb, index), valueAt(b.image.rgb, index)};
  }
  result.zRejectedFraction = std::numeric_limits<double>::quiet_NaN();
  result.equivalence.p = std::numeric_limits<double>::quiet_NaN();
  result.a = std::move(a);
  result.b = std::move(b);
  return result;
}

void addZMap(Comparison& comparison, const ImageEstimate& a, const ImageEstimate& b) {
  ZMap map = zMap(a, b, kZMapRate);
  comparison.z = std::move(map.z);
  comparison.zRejectedFraction = map.rejectedFraction;
}

}  // namespace twintrace
