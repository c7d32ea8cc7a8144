#include "experiments/explain/difference_classes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "experiments/explain/explanation.h"

namespace twintrace {
namespace {

struct DifferingPixel {
  PixelPosition pixel;
  std::uint32_t frame = 0;  ///< the first that differs
};

std::vector<DifferingPixel> differingPixels(const FrameDifferences& differences,
                                            const Image& image) {
  std::vector<DifferingPixel> pixels;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto frame = differences.firstFrame({x, y});
      if (frame) pixels.push_back({{x, y}, *frame});
    }
  }
  return pixels;
}

/// Evenly spread ones, in row order.
std::vector<DifferingPixel> spread(const std::vector<DifferingPixel>& all) {
  const std::size_t count = std::min<std::size_t>(all.size(), kMostExplained);
  std::vector<DifferingPixel> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
  return some;
}

double energyOf(const Comparison& comparison, const PixelPosition& pixel) {
  const std::size_t at = pixelIndex(pixel, comparison.a.image.width);
  const auto a = valueAt(comparison.a.image.rgb, at);
  const auto b = valueAt(comparison.b.image.rgb, at);
  double energy = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double difference = std::fabs(double{a[i]} - double{b[i]});
    if (std::isfinite(difference)) energy += difference;
  }
  return energy;
}

class Examination {
 public:
  Examination(ArmsComparison& result, const Arm& a, const Arm& b)
      : comparison_(result.comparison),
        options_(a.options),
        a_(makePathTracer(a.scene, a.options, TraceDetail::calls)),
        b_(makePathTracer(b.scene, b.options, TraceDetail::calls)) {
    comparison_.divergeBounce.assign(comparison_.a.image.pixelCount(), -1.0f);
  }

  void examine(const DifferingPixel& differing) {
    const auto [kind, bounce] = explain(differing);
    DifferenceShares& shares = comparison_.classes;
    DifferenceShare& share = shares.byClass[std::string(className(kind))];
    const double energy = energyOf(comparison_, differing.pixel);
    ++shares.examined;
    ++share.pixels;
    share.energy += energy;
    const std::size_t at = pixelIndex(differing.pixel, comparison_.a.image.width);
    comparison_.divergeBounce[at] = static_cast<float>(bounce);
  }

 private:
  std::pair<DifferenceClass, int> explain(const DifferingPixel& differing) {
    const std::int64_t first =
        options_.firstSample + std::int64_t{differing.frame} * options_.passes;
    for (std::int64_t sample = first; sample < first + options_.passes; ++sample) {
      SampleExplanation e;
      explainSample(*a_, *b_, differing.pixel, static_cast<std::uint32_t>(sample), e);
      if (!e.sameRadiance) {
        return {e.kind, e.divergence ? std::max(e.divergence->step, 0) : -1};
      }
    }
    return {DifferenceClass::unexplained, -1};
  }

  Comparison& comparison_;
  RenderOptions options_;
  std::unique_ptr<PathTracer> a_;
  std::unique_ptr<PathTracer> b_;
};

/// Counts and sums become shares of what was examined.
void normalise(DifferenceShares& shares) {
  double energy = 0;
  for (const auto& [name, share] : shares.byClass) energy += share.energy;
  for (auto& [name, share] : shares.byClass) {
    share.pixels /= shares.examined;
    if (energy > 0) share.energy /= energy;
  }
}

std::string summary(const DifferenceShares& shares, std::size_t differing) {
  std::string text =
      fmt::format("{} of {} differing pixels explained:", shares.examined, differing);
  for (const auto& [name, share] : shares.byClass) {
    text += fmt::format(" {} {:.1f} % ({:.1f} % of the energy)", name, 100 * share.pixels,
                        100 * share.energy);
  }
  return text;
}

}  // namespace

void addDifferenceClasses(ArmsComparison& result, const Arm& a, const Arm& b,
                          const JobControl& control) {
  if (!result.differences) return;
  const auto all = differingPixels(*result.differences, result.comparison.a.image);
  if (all.empty()) return;
  Examination examination(result, a, b);
  const auto start = std::chrono::steady_clock::now();
  for (const DifferingPixel& differing : spread(all)) {
    examination.examine(differing);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (elapsed.count() > kExplainSeconds || control.stopRequested()) break;
  }
  normalise(result.comparison.classes);
  result.comparison.notes.push_back(summary(result.comparison.classes, all.size()));
}

}  // namespace twintrace
