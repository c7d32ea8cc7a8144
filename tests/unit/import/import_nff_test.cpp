#include "common/import/import_nff.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "common/scene/flat_scene.h"
#include "common/scene/reader.h"
#include "cpu/kernel_caster.h"
#include "tests/catch.h"
#include "tests/unit/experiments/temporary_directory.h"

using namespace twintrace;
using Catch::Matchers::Contains;

namespace {

const std::string kView =
    "v\nfrom 0 0 10\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\n"
    "resolution 513 513\n";

ImportedScene imported(const std::string& text) {
  return sceneOfNff(parseNff(text, "a.nff"), "a.nff");
}

Material onlyMaterial(const std::string& fill) {
  const ImportedScene scene = imported(fill + "s 0 0 0 1\n");
  REQUIRE(scene.parts.size() == 1);
  return scene.parts[0].material;
}

std::string notesOf(const std::string& text) {
  std::string notes;
  for (const std::string& note : imported(text).notes) notes += note + "\n";
  return notes;
}

/// How many rays through the centres of a scene's pixels hit something.
std::int64_t hitCount(const std::string& path) {
  const Scene scene = readScene(path);
  const auto flat = std::make_shared<const FlatScene>(flatten(scene, scene.render));
  std::vector<CastRay> rays;
  for (int y = 0; y < flat->height; ++y) {
    for (int x = 0; x < flat->width; ++x) {
      const FlatCamera& camera = flat->camera;
      const glm::vec3 direction =
          camera.corner + (float(x) + 0.5f) * camera.stepX + (float(y) + 0.5f) * camera.stepY;
      rays.push_back({camera.origin, direction});
    }
  }
  const auto hits = makeKernelCaster(flat, scene.render)->cast(rays);
  return std::ranges::count_if(hits, &CastHit::valid);
}

}  // namespace

TEST_CASE("fovOfNff puts the centres of the outermost rows at the ends of the angle", "[import]") {
  for (const int pixels : {2, 3, 512, 513}) {
    INFO(pixels);
    const double half = std::tan(glm::radians(fovOfNff(45.0, pixels)) / 2.0);
    // The topmost centre lies half a pixel below the edge.
    const double centre = half * (1.0 - 1.0 / pixels);
    CHECK(glm::degrees(2.0 * std::atan(centre)) == Approx(45.0).epsilon(1e-12));
  }
  CHECK(fovOfNff(45.0, 513) == Approx(45.0791).epsilon(1e-6));
}

TEST_CASE("sceneOfNff takes view and background", "[import]") {
  const ImportedScene scene = imported(kView + "b 0.1 0.2 0.3\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n");
  CHECK(scene.width == 513);
  CHECK(scene.camera.eye == glm::vec3(0, 0, 10));
  CHECK(scene.camera.fov == float(fovOfNff(45.0, 513)));
  CHECK(scene.background == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(scene.notes.empty());
}

TEST_CASE("sceneOfNff takes Kd times the colour and a white Ks", "[import]") {
  const Material material = onlyMaterial("f 1 0.5 0.25 0.6 0.4 31.622776 0 1\n");
  CHECK(material.albedo.g == Approx(0.3));
  CHECK(material.specular == glm::vec3(0.4f));
  CHECK(material.highlight == glm::vec3(0.4f));
  CHECK(material.exponent == Approx(31.622776));
  // 1000^((1 - r)^2) = 1000^(1/2)
  CHECK(material.roughness == Approx(1.0 - std::sqrt(0.5)));
  CHECK(material.lobe == Lobe::phong);
  CHECK(onlyMaterial("f 1 1 1 0.5 0.5 100000 0 1\n").roughness == 0.0f);
  CHECK(onlyMaterial("f 1 1 1 0.5 0.5 0 0 1\n").roughness == 1.0f);
}

TEST_CASE("sceneOfNff scales lobes that add up to more than 1, and says so", "[import]") {
  const std::string fill = "f 1 0.5 0.25 0.75 0.5 10 0 1\n";
  const Material material = onlyMaterial(fill);
  CHECK(material.albedo.r == Approx(0.6));
  CHECK(material.specular.r == Approx(0.4));
  CHECK(material.albedo.r + material.specular.r <= 1.0f);
  CHECK_THAT(notesOf(fill + "s 0 0 0 1\n"),
             Contains("1 material reflects more than it receives (diffuse and specular add up to "
                      "1.25) and is scaled to add up to 1"));
}

TEST_CASE("sceneOfNff says that what lets light through stays opaque", "[import]") {
  CHECK_THAT(notesOf("f 1 1 1 0.2 0 0 0.8 1.1\ns 0 0 0 1\n"),
             Contains("1 fill lets light through (T), here it is opaque"));
  // Without T the index of refraction means nothing.
  CHECK_THAT(notesOf("f 1 1 1 0.2 0 0 0 1.1\ns 0 0 0 1\n"), !Contains("light through"));
}

TEST_CASE("sceneOfNff gives lights 1 / sqrt(n) where the camera aims at", "[import]") {
  const ImportedScene scene = imported(
      kView + "l 0 3 4\nl 0 0 2 0.5 1 0\nl 1 0 0\nl 0 1 0\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n");
  REQUIRE(scene.lights.size() == 4);
  CHECK(std::get<PointLight>(scene.lights[0]).position == glm::vec3(0, 3, 4));
  CHECK(std::get<PointLight>(scene.lights[0]).intensity == glm::vec3(12.5f));
  CHECK(std::get<PointLight>(scene.lights[1]).intensity == glm::vec3(2.0f, 4.0f, 0.0f));
}

TEST_CASE("sceneOfNff frames all of it where there is no view", "[import]") {
  const ImportedScene scene = imported("f 1 1 1 1 0 0 0 0\ns 5 0 0 1\ns 7 0 0 1\n");
  CHECK(scene.camera.target == glm::vec3(6, 0, 0));
  // The box from 4 to 8 in x and from -1 to 1 in y and z lies within a ball of this radius.
  const double radius = std::sqrt(6.0);
  CHECK(glm::length(glm::dvec3(scene.camera.eye) - glm::dvec3(6, 0, 0)) ==
        Approx(radius / std::sin(glm::radians(20.0))));
  CHECK(scene.notes ==
        std::vector<std::string>{"no view: the camera sees all of it from the front"});
}

TEST_CASE("sceneOfNff rejects a file without surfaces", "[import]") {
  CHECK_THROWS_WITH(imported(kView), "a.nff: found no surface, expected at least one");
}

TEST_CASE("sceneText of an NFF file reads back as the same scene", "[import]") {
  const test::TemporaryDirectory directory;
  test::writeBytes(directory.file("a.nff"),
                   kView +
                       "b 0.1 0.2 0.3\nl 0 3 4\nf 1 0.5 0.25 0.6 0.4 31.6 0 1\ns 1 2 3 4\n"
                       "c 0 0 0 1 0 0 1 1\nf 0 1 0 1 0 0 0 0\np 3\n0 0 0\n1 0 0\n0 1 0\n");
  std::filesystem::create_directory(directory.file("out"));
  const ImportedScene from = importScene(directory.file("a.nff"));
  test::writeBytes(directory.file("out/a.toml"), sceneText(from, directory.file("out")));
  const Scene scene = readScene(directory.file("out/a.toml"));
  CHECK(scene.name == "a");
  CHECK(scene.render.width == 513);
  CHECK(scene.camera.eye == from.camera.eye);
  CHECK(scene.camera.fov == from.camera.fov);
  CHECK(scene.environment.radiance == from.background);
  REQUIRE(scene.materials.size() == 2);
  CHECK(scene.materials[0].albedo == from.parts[0].material.albedo);
  CHECK(scene.materials[0].specular == from.parts[0].material.specular);
  CHECK(scene.materials[0].roughness == from.parts[0].material.roughness);
  CHECK(scene.materials[0].highlight == from.parts[0].material.highlight);
  CHECK(scene.materials[0].exponent == from.parts[0].material.exponent);
  REQUIRE(scene.lights.size() == 1);
  REQUIRE(scene.objects.size() == 2);
  const FlatScene flat = flatten(scene, scene.render);
  CHECK(flat.index.sphereCount == 1);
  CHECK(flat.index.triangleCount == 129);
  CHECK(flat.index.smoothCount == 128);
  CHECK(flat.primitiveObject.front() == 0);
  CHECK(flat.primitiveObject.back() == 1);
}

TEST_CASE("An imported camera's outermost pixels have their centres at the ends of the angle",
          "[import]") {
  const test::TemporaryDirectory directory;
  const auto hits = [&](const char* half) {
    const std::string h = half;
    test::writeBytes(directory.file("a.nff"),
                     "v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 90\nhither 1\nresolution 9 9\n"
                     "f 1 1 1 1 0 0 0 0\np 4\n-" +
                         h + " -" + h + " 0\n" + h + " -" + h + " 0\n" + h + " " + h + " 0\n-" + h +
                         " " + h + " 0\n");
    test::writeBytes(directory.file("a.toml"),
                     sceneText(importScene(directory.file("a.nff")), directory.path()));
    return hitCount(directory.file("a.toml"));
  };
  CHECK(hits("1.0001") == 81);
  CHECK(hits("0.9999") == 49);
}
