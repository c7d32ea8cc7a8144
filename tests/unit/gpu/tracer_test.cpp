#include "gpu/tracer.h"

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
