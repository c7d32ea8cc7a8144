#include "experiments/first_difference.h"

#include "common/base/float_bits.h"

namespace twintrace {
namespace {

bool sameValue(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return sameBits(a[0], b[0]) && sameBits(a[1], b[1]) && sameBits(a[2], b[2]);
}

}  // namespace

FrameDifferences::FrameDifferences(int width, int height)
    : width_(width),
      firstFrame_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNone) {}

void FrameDifferences::add(std::span<const float> a, std::span<const float> b) {
  for (std::size_t pixel = 0; pixel < firstFrame_.size(); ++pixel) {
    if (firstFrame_[pixel] == kNone && !sameValue(valueAt(a, pixel), valueAt(b, pixel))) {
      firstFrame_[pixel] = frameCount_;
    }
  }
  ++frameCount_;
}

std::optional<std::uint32_t> FrameDifferences::firstFrame(const PixelPosition& pixel) const {
  const std::size_t index = pixelIndex(pixel, width_);
  if (firstFrame_[index] == kNone) return std::nullopt;
  return firstFrame_[index];
}

FirstDifference locateDifference(const PixelPosition& pixel, const Image& a, const Image& b,
                                 Arm& armA, Arm& armB, std::optional<std::uint32_t> frame,
                                 const JobControl& control) {
  const std::size_t index = pixelIndex(pixel, a.width);
  FirstDifference result{pixel, std::nullopt, valueAt(a.rgb, index), valueAt(b.rgb, index)};
  if (!frame) return result;
  const RenderOptions& options = armA.options;
  std::vector<float> sumsA(a.rgb.size());
  std::vector<float> sumsB(b.rgb.size());
  const std::int64_t first = options.firstSample + std::int64_t{*frame} * options.passes;
  for (std::int64_t sample = first; sample < first + options.passes; ++sample) {
    armA.renderer->renderFrame(static_cast<std::uint32_t>(sample), 1, sumsA);
    armB.renderer->renderFrame(static_cast<std::uint32_t>(sample), 1, sumsB);
    const auto valueA = valueAt(sumsA, index);
    const auto valueB = valueAt(sumsB, index);
    if (!sameValue(valueA, valueB)) return {pixel, sample, valueA, valueB};
    if (control.stopRequested()) break;
  }
  return result;
}

}  // namespace twintrace
