#include "experiments/explain/plain_sample.h"

#include <fmt/format.h>

#include "common/base/float_bits.h"

namespace twintrace {
namespace {

bool same(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return sameBits(a[0], b[0]) && sameBits(a[1], b[1]) && sameBits(a[2], b[2]);
}

std::array<float, 3> renderPixel(Arm& arm, const PixelPosition& pixel, std::int64_t sample) {
  const RenderOptions& options = arm.options;
  std::vector<float> sums(static_cast<std::size_t>(options.width) *
                          static_cast<std::size_t>(options.height) * 3);
  arm.renderer->renderFrame(static_cast<std::uint32_t>(sample), 1, sums);
  const auto value = valueAt(sums, pixelIndex(pixel, options.width));
  return {value[0], value[1], value[2]};
}

std::string otherwise(const char* arm, const std::array<float, 3>& plain, bool native) {
  return fmt::format(
      "{}: the traced program does not show what the plain one renders: {:a} {:a} {:a}{}", arm,
      plain[0], plain[1], plain[2], native ? ", as native maths may" : "");
}

}  // namespace

bool PlainSample::differs() const {
  return !same(a, b);
}

PlainSample renderPlainSample(Arm& a, Arm& b, const PixelPosition& pixel, std::int64_t sample) {
  return {renderPixel(a, pixel, sample), renderPixel(b, pixel, sample)};
}

std::vector<std::string> traceNotes(const PlainSample& plain, const SampleExplanation& explanation,
                                    bool native) {
  std::vector<std::string> notes;
  if (!same(plain.a, explanation.traceA.radiance)) notes.push_back(otherwise("a", plain.a, native));
  if (!same(plain.b, explanation.traceB.radiance)) notes.push_back(otherwise("b", plain.b, native));
  if (plain.differs() && explanation.sameRadiance) {
    notes.emplace_back(
        "the plain programs differ in this sample, the traced ones no longer do: "
        "what is shown does not explain the difference");
  } else if (!plain.differs() && !explanation.sameRadiance) {
    notes.emplace_back("the traced programs differ in this sample, the plain ones do not");
  } else if (native && notes.empty()) {
    notes.emplace_back("native maths: the traced programs show what the plain ones render");
  }
  return notes;
}

}  // namespace twintrace
