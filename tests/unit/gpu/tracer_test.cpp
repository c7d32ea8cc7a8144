#include "gpu/tracer.h"

#include <cmath>

#include "common/base/error.h"
#include "common/base/float_bits.h"
#include "common/scene/reader.h"
#include "cpu/tracer.h"
#include "tests/catch.h"
#include "tests/unit/gpu/gl_fixture.h"

using namespace twintrace;

namespace {

Scene openScene() { return readScene(TWINTRACE_SOURCE_DIR "/experiments/scenes/open.toml"); }

std::vector<float> frame(Renderer& renderer, const RenderOptions& options) {
  std::vector<float> sums(std::size_t{3} * options.width * options.height);
  renderer.renderFrame(0, 1, sums);
  return sums;
}

}  // namespace

TEST_CASE("GpuRenderer draws films beyond one tile, wide or high", "[gl]") {
  const Scene scene = openScene();
  for (const Stage stage : {Stage::fragment, Stage::compute}) {
    for (const bool wide : {true, false}) {
      RenderOptions options = scene.render;
      options.width = wide ? 4099 : 3;
      options.height = wide ? 3 : 4099;
      options.stage = stage;
      const auto flat = std::make_shared<const FlatScene>(flatten(scene, options));
      std::unique_ptr<Renderer> gpu;
      try {
        gpu = makeGpuRenderer(flat, options);
      } catch (const DeviceError& error) {
        WARN("skipped: " << error.what());
        return;
      }
      const std::vector<float> a = frame(*gpu, options);
      const std::vector<float> b = frame(*makeCpuRenderer(flat, options), options);
      std::size_t differing = 0;
      for (std::size_t i = 0; i < a.size(); ++i) differing += sameBits(a[i], b[i]) ? 0 : 1;
      CHECK(differing == 0);
    }
  }
}

TEST_CASE("GpuRenderer gives all passes of scenes whose loops the device would end", "[gl]") {
  Scene scene;
  scene.materials.emplace_back().albedo = glm::vec3(0.7f);
  scene.environment.radiance = glm::vec3(1.0f);
  for (int i = 0; i < 700; ++i) {
    const float angle = 0.37f * static_cast<float>(i);
    const glm::vec3 center(std::cos(angle) * 0.05f * static_cast<float>(i % 40),
                           std::sin(angle) * 0.05f * static_cast<float>(i % 40), -0.01f * static_cast<float>(i));
    scene.objects.push_back({"ball" + std::to_string(i), SphereShape{center, 0.2f}, 0});
  }
  scene.camera.eye = {0.0f, 0.0f, 5.0f};
  for (const Stage stage : {Stage::fragment, Stage::compute}) {
    RenderOptions options;
    options.width = options.height = 16;
    options.passes = 32;  // 700 tests a ray, some 3 rays a pass: llvmpipe ends loops after 65,535 rounds
    options.hull = "none";
    options.stage = stage;
    const auto flat = std::make_shared<const FlatScene>(flatten(scene, options));
    std::unique_ptr<Renderer> gpu;
    try {
      gpu = makeGpuRenderer(flat, options);
    } catch (const DeviceError& error) {
      WARN("skipped: " << error.what());
      return;
    }
    std::vector<float> a(std::size_t{3} * 16 * 16);
    std::vector<float> b(a.size());
    gpu->renderFrame(0, options.passes, a);
    makeCpuRenderer(flat, options)->renderFrame(0, options.passes, b);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.size(); ++i) differing += sameBits(a[i], b[i]) ? 0 : 1;
    CHECK(differing == 0);
  }
}

TEST_CASE("makeGpuRenderer refuses options of the CPU back end", "[unit]") {
  const Scene scene = openScene();
  RenderOptions options = scene.render;
  const auto flat = std::make_shared<const FlatScene>(flatten(scene, options));
  options.precision = Precision::float64;
  CHECK_THROWS_AS(makeGpuRenderer(flat, options), UsageError);
  options.precision = Precision::float32;
  options.hull = "embree";
  CHECK_THROWS_AS(makeGpuRenderer(flat, options), UsageError);
}
