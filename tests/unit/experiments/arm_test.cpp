#include "experiments/arm.h"

#include "common/base/error.h"
#include "common/scene/reader.h"
#include "tests/catch.h"
#include "tests/unit/experiments/temporary_directory.h"

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

TEST_CASE("filmMetadata names shaders from a directory by their texts", "[experiments]") {
  const test::TemporaryDirectory directory;
  RenderOptions gpu = ballOptions();
  gpu.backend = BackEnd::gpu;
  gpu.shaderDirectory = directory.path();
  test::writeBytes(directory.file("a.glsl"), "one");
  const std::string hash = metadataOf(gpu).at("shader_hash");
  test::writeBytes(directory.file("notes.txt"), "no shader");
  CHECK(metadataOf(gpu).at("shader_hash") == hash);
  test::writeBytes(directory.file("a.glsl"), "two");
  CHECK(metadataOf(gpu).at("shader_hash") != hash);
  gpu.backend = BackEnd::cpu;
  CHECK(metadataOf(gpu) == metadataOf(ballOptions()));
}

TEST_CASE("filmMetadata names overrides by shader and text, not by file", "[experiments]") {
  RenderOptions gpu = ballOptions();
  gpu.backend = BackEnd::gpu;
  CHECK_FALSE(metadataOf(gpu).contains("shader_overrides"));
  gpu.shaderOverrides = {{"math.glsl", "a", "one"}};
  const std::string hash = metadataOf(gpu).at("shader_overrides");
  CHECK(hash.find("math.glsl=") == 0);
  gpu.shaderOverrides = {{"math.glsl", "b", "one"}};
  CHECK(metadataOf(gpu).at("shader_overrides") == hash);
  gpu.shaderOverrides = {{"math.glsl", "a", "two"}};
  CHECK(metadataOf(gpu).at("shader_overrides") != hash);
  gpu.backend = BackEnd::cpu;
  CHECK(metadataOf(gpu) == metadataOf(ballOptions()));
}

TEST_CASE("openArm names the driver of native maths", "[experiments][gl]") {
  RenderOptions gpu = ballOptions();
  gpu.backend = BackEnd::gpu;
  CHECK_FALSE(openArm(ballScene(), gpu).metadata.contains("gl_renderer"));
  gpu.maths = Maths::native;
  const FilmMetadata metadata = openArm(ballScene(), gpu).metadata;
  CHECK(metadata.at("gl") == "osmesa");
  CHECK_FALSE(metadata.at("gl_renderer").empty());
  CHECK_FALSE(metadata.at("gl_version").empty());
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
