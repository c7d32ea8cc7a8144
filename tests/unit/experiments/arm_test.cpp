#include "experiments/arm.h"

#include "common/base/error.h"
#include "common/scene/reader.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

Scene ballScene() {
  return parseScene(
      "[film]\nwidth = 8\nheight = 8\n[materials.m]\nalbedo = [0.5, 0.5, 0.5]\n"
      "[[objects]]\nshape = \"sphere\"\ncenter = [0.0, 0.0, 0.0]\nradius = 1.0\nmaterial = \"m\"\n",
      "ball.toml");
}

FilmMetadata metadataOf(const RenderOptions& options) {
  const Scene scene = ballScene();
  return filmMetadata(scene, *flattenScene(scene, options), options);
}

RenderOptions ballOptions() {
  return ballScene().render;
}

}  // namespace

TEST_CASE("filmMetadata of strict float arms names no back end", "[experiments]") {
  RenderOptions gpu = ballOptions();
  gpu.backend = BackEnd::gpu;
  gpu.stage = Stage::compute;
  gpu.lanes = Lanes::scalar;
  gpu.threads = 3;
  CHECK(metadataOf(gpu) == metadataOf(ballOptions()));
}

TEST_CASE("filmMetadata of native arms names the back end", "[experiments]") {
  RenderOptions cpu = ballOptions();
  cpu.maths = Maths::native;
  RenderOptions gpu = cpu;
  gpu.backend = BackEnd::gpu;
  CHECK(metadataOf(cpu).at("backend") == "cpu");
  CHECK(metadataOf(gpu).at("backend") == "gpu");
  CHECK(metadataOf(gpu).at("stage") == "fragment");
}

TEST_CASE("filmMetadata counts effects only where they can show", "[experiments]") {
  RenderOptions all = ballOptions();
  all.effects = "all";
  RenderOptions some = ballOptions();
  some.effects = "sphere";
  CHECK(metadataOf(all) == metadataOf(ballOptions()));
  CHECK(metadataOf(some) != metadataOf(ballOptions()));
}

TEST_CASE("openArm refuses what a GPU lacks", "[experiments]") {
  RenderOptions options = ballOptions();
  options.backend = BackEnd::gpu;
  options.precision = Precision::float64;
  CHECK_THROWS_AS(openArm(ballScene(), options), UsageError);
  options.precision = Precision::float32;
  options.hull = "embree";
  CHECK_THROWS_AS(openArm(ballScene(), options), UsageError);
}

}  // namespace twintrace
