// The unpaired tests on real renders: how often they see a difference between two seeds of one
// arm, and what they say of arms that do and do not agree.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "common/scene/flat_scene.h"
#include "common/scene/reader.h"
#include "common/stats/batch_means.h"
#include "common/stats/distributions.h"
#include "common/stats/equivalence.h"
#include "common/stats/family_test.h"
#include "common/stats/verdict.h"
#include "cpu/tracer.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

/// Chance that a sound test fails the calibration; seeds are fixed, so it does so always or never.
constexpr double kCalibrationAlpha = 1e-6;

// A sanitizer looks for faults, which the first pairs would show, and slows renders down
// hundredfold.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kPairs = 20;
#else
constexpr int kPairs = 1000;
#endif
constexpr int kBatches = 32;

Scene shippedScene(const std::string& name) {
  return readScene(std::filesystem::path(TWINTRACE_SOURCE_DIR) / "experiments" / "scenes" /
                   (name + ".toml"));
}

RenderOptions optionsOf(const Scene& scene, int size, int samplesPerBatch) {
  RenderOptions options = scene.render;
  options.integrator = Integrator::path;
  options.width = size;
  options.height = size;
  options.passes = samplesPerBatch;
  return options;
}

/// Frames of one render as batches.
BatchMeans renderBatches(const Scene& scene, const RenderOptions& options) {
  const auto flat = std::make_shared<const FlatScene>(flatten(scene, options));
  const auto renderer = makeCpuRenderer(flat, options);
  BatchMeans batches(options.width, options.height);
  Image image(options.width, options.height);
  for (int batch = 0; batch < kBatches; ++batch) {
    const auto first = static_cast<std::uint32_t>(batch * options.passes);
    renderer->renderFrame(first, options.passes, image.rgb);
    for (float& value : image.rgb) value /= static_cast<float>(options.passes);
    batches.add(image);
  }
  return batches;
}

/// Compares the path tracer with one whose options are changed, at another seed.
template <class Change>
Verdict verdictOfChange(const std::string& name, int samplesPerBatch, Change change) {
  const Scene scene = shippedScene(name);
  const RenderOptions plain = optionsOf(scene, 64, samplesPerBatch);
  RenderOptions changed = plain;
  change(changed);
  changed.seed = plain.seed + 1;
  const BatchMeans a = renderBatches(scene, plain);
  const BatchMeans b = renderBatches(scene, changed);
  const Equivalence equivalence =
      equivalenceTest(channelMeans(a), channelMeans(b), kEquivalenceBound, kEquivalenceAlpha);
  return unpairedVerdict(familyTest(a, b, kEquivalenceAlpha), equivalence);
}

bool withinBound(const std::string& scene, int alarms, double alpha) {
  const double p = binomialUpper(alarms, kPairs, alpha);
  std::printf("family, renders of %-16s alpha %-6g false alarms %3d of %d = %.4f, p = %.2g\n",
              scene.c_str(), alpha, alarms, kPairs, double(alarms) / kPairs, p);
  return p > kCalibrationAlpha;
}

/// False alarms among pairs of renders that differ in the seed alone, 3 x 3 blocks.
void calibrate(const std::string& name, int samplesPerBatch) {
  const Scene scene = shippedScene(name);
  RenderOptions options = optionsOf(scene, 24, samplesPerBatch);
  int alarms5 = 0;
  int alarms1 = 0;
  for (std::uint32_t pair = 0; pair < kPairs; ++pair) {
    options.seed = 2 * pair;
    const BatchMeans a = renderBatches(scene, options);
    options.seed = 2 * pair + 1;
    const BatchMeans b = renderBatches(scene, options);
    alarms5 += familyTest(a, b, 0.05).different;
    alarms1 += familyTest(a, b, 0.01).different;
  }
  CHECK(withinBound(name, alarms5, 0.05));
  CHECK(withinBound(name, alarms1, 0.01));
}

}  // namespace

TEST_CASE("familyTest keeps its false-alarm rate on renders of cornell", "[statistical][renders]") {
  calibrate("cornell", 2);
}

TEST_CASE("familyTest keeps its false-alarm rate on renders of roughness-row",
          "[statistical][renders]") {
  calibrate("roughness-row", 1);
}

// furnace-diffuse has noise at the ball's rim only, a mean well known after some samples.
TEST_CASE("native and strict maths are equivalent on furnace-diffuse", "[statistical][renders]") {
  const auto native = [](RenderOptions& options) { options.maths = Maths::native; };
  CHECK(verdictOfChange("furnace-diffuse", 4, native) == Verdict::equivalent);
}

// Measured: after these 8 million samples the mean of red, the noisiest channel, is known to 0.06 %
// in one arm and to 0.1 % as the ratio of two, a fifth of the bound.
TEST_CASE("native and strict maths are equivalent on open", "[statistical][renders]") {
  const auto native = [](RenderOptions& options) { options.maths = Maths::native; };
  CHECK(verdictOfChange("open", 64, native) == Verdict::equivalent);
}

TEST_CASE("float and double are equivalent on open", "[statistical][renders]") {
  const auto precise = [](RenderOptions& options) { options.precision = Precision::float64; };
  CHECK(verdictOfChange("open", 64, precise) == Verdict::equivalent);
}

// The report's doubled cosine takes a third of the ball's radiance.
TEST_CASE("path and report are different on furnace-diffuse", "[statistical][renders]") {
  const auto report = [](RenderOptions& options) {
    options.integrator = Integrator::report;
    options.intersector = Intersector::report;
  };
  CHECK(verdictOfChange("furnace-diffuse", 4, report) == Verdict::different);
}

}  // namespace twintrace
