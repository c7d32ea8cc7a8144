// Whole pictures: in strict maths every arm renders the same sums, to the bit, for all shipped
// scenes, integrators and noises.

#include <bit>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/base/float_bits.h"
#include "common/scene/flat_scene.h"
#include "common/scene/reader.h"
#include "cpu/tracer.h"
#include "gpu/provider.h"
#include "gpu/tracer.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

constexpr int kSize = 48;   // pixels, each way: not a multiple of the CPU's tiles
constexpr int kPasses = 3;  // samples per frame
constexpr int kFrames = 2;

/// One way to render; `set` is for the CPU only.
struct Arm {
  std::string name;
  RenderOptions options;
  InstructionSet set = InstructionSet::sse2;
};

std::vector<std::filesystem::path> shippedScenes() {
  std::vector<std::filesystem::path> scenes;
  const auto folder = std::filesystem::path(TWINTRACE_SOURCE_DIR) / "experiments" / "scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  }
  return scenes;
}

std::vector<InstructionSet> availableSets() {
  std::vector<InstructionSet> sets;
  for (const auto set : {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set <= bestInstructionSet()) sets.push_back(set);
  }
  return sets;
}

/// The scalar text is built twice, for sse2 and avx2.
std::vector<Arm> cpuArms(const RenderOptions& base) {
  std::vector<Arm> arms;
  for (const InstructionSet set : availableSets()) {
    RenderOptions options = base;
    const std::string name = instructionSetName(set);
    options.lanes = Lanes::scalar;
    if (set != InstructionSet::avx512) arms.push_back({"cpu scalar " + name, options, set});
    options.lanes = Lanes::wide;
    arms.push_back({"cpu wide " + name, options, set});
  }
  RenderOptions hull = base;
  hull.hull = "embree";
  if (base.intersector == Intersector::robust) {
    arms.push_back({"cpu embree hull", hull, bestInstructionSet()});
  }
  return arms;
}

std::vector<Arm> gpuArms(const RenderOptions& base, Provider provider) {
  const std::string prefix = provider == Provider::egl ? "egl " : "osmesa ";
  RenderOptions options = base;
  options.backend = BackEnd::gpu;
  options.provider = provider;
  std::vector<Arm> arms = {{prefix + "fragment", options}};
  options.stage = Stage::compute;
  arms.push_back({prefix + "compute", options});
  options.stage = Stage::fragment;
  options.effects = "all";
  options.geometry = Geometry::buffer;
  arms.push_back({prefix + "fragment, all effects, buffers", options});
  return arms;
}

/// The sums of all frames, one frame after the other.
std::vector<float> render(const Scene& scene, const Arm& arm) {
  const auto flat = std::make_shared<const FlatScene>(flatten(scene, arm.options));
  const auto renderer = arm.options.backend == BackEnd::gpu
                            ? makeGpuRenderer(flat, arm.options)
                            : makeCpuRenderer(flat, arm.options, {arm.set, 32});
  constexpr std::size_t kFrameSize = std::size_t{kSize} * kSize * 3;
  std::vector<float> sums(kFrameSize * kFrames);
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    renderer->renderFrame(static_cast<std::uint32_t>(frame) * kPasses, kPasses,
                          std::span(sums).subspan(frame * kFrameSize, kFrameSize));
  }
  return sums;
}

std::string hexText(float value) {
  char text[64];
  std::snprintf(text, sizeof text, "%08x = %a", std::bit_cast<std::uint32_t>(value),
                static_cast<double>(value));
  return text;
}

/// Where the first difference is and how many there are; empty if there is none.
std::string firstDifference(const std::vector<float>& a, const std::vector<float>& b) {
  std::size_t count = 0;
  std::size_t first = 0;
  for (std::size_t i = a.size(); i-- > 0;) {
    if (sameBits(a[i], b[i])) continue;
    ++count;
    first = i;
  }
  if (count == 0) return {};
  const std::size_t pixel = first / 3;
  const std::size_t inFrame = pixel % (std::size_t{kSize} * kSize);
  return std::to_string(count) + " values differ, first in frame " +
         std::to_string(pixel / (std::size_t{kSize} * kSize)) + ", pixel (" +
         std::to_string(inFrame % kSize) + ", " + std::to_string(inFrame / kSize) + "), channel " +
         "RGB"[first % 3] + ": " + hexText(a[first]) + " against " + hexText(b[first]);
}

bool isAvailable(Provider provider) {
  try {
    createContext(provider, 0);
    return true;
  } catch (const DeviceError& error) {
    WARN("left out: " << error.what());
    return false;
  }
}

RenderOptions optionsOf(const Scene& scene, Integrator integrator, Noise noise) {
  RenderOptions options = scene.render;
  options.integrator = integrator;
  options.noise = noise;
  options.intersector =
      integrator == Integrator::report ? Intersector::report : Intersector::robust;
  options.maths = Maths::strict;
  options.precision = Precision::float32;
  options.width = kSize;
  options.height = kSize;
  options.passes = kPasses;
  return options;
}

const char* noiseName(Noise noise) { return noise == Noise::sine ? "sine" : "pcg"; }

void checkPictures(const Scene& scene, const RenderOptions& options,
                   const std::vector<Provider>& providers) {
  std::vector<Arm> arms = cpuArms(options);
  for (const Provider provider : providers) {
    for (Arm& arm : gpuArms(options, provider)) arms.push_back(std::move(arm));
  }
  const std::vector<float> reference = render(scene, arms.front());
  for (std::size_t i = 1; i < arms.size(); ++i) {
    const std::string difference = firstDifference(reference, render(scene, arms[i]));
    if (difference.empty()) continue;
    FAIL_CHECK(scene.name << ", noise " << noiseName(options.noise) << ", " << arms[0].name
                          << " against " << arms[i].name << ": " << difference);
  }
}

void checkAllScenes(Integrator integrator) {
  std::vector<Provider> providers;
  for (const Provider provider : {Provider::osmesa, Provider::egl}) {
    if (isAvailable(provider)) providers.push_back(provider);
  }
  const auto scenes = shippedScenes();
  CHECK(scenes.size() >= 8);
  for (const auto& path : scenes) {
    const Scene scene = readScene(path);
    for (const Noise noise : {Noise::sine, Noise::pcg}) {
      checkPictures(scene, optionsOf(scene, integrator, noise), providers);
    }
  }
}

}  // namespace

TEST_CASE("all arms render the same picture with integrator path", "[parity][gl]") {
  checkAllScenes(Integrator::path);
}

TEST_CASE("all arms render the same picture with integrator report", "[parity][gl]") {
  checkAllScenes(Integrator::report);
}

TEST_CASE("all arms render the same picture with integrator whitted", "[parity][gl]") {
  checkAllScenes(Integrator::whitted);
}

TEST_CASE("all arms render the same picture with integrator local", "[parity][gl]") {
  checkAllScenes(Integrator::local);
}

}  // namespace twintrace
