#include "common/import/import_model.h"

#include <glm/geometric.hpp>

#include "common/base/error.h"
#include "common/scene/flat_scene.h"
#include "common/scene/reader.h"
#include "tests/catch.h"
#include "tests/unit/experiments/temporary_directory.h"

using namespace twintrace;
using Catch::Matchers::Contains;

namespace {

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

/// One triangle at z = 0 under a node that is moved by (0, 0, -5), a camera at (0, 0, 3) that looks
/// along -z turned by nothing, and a point light.
const std::string kGltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],
"extensionsUsed":["KHR_lights_punctual"],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","color":[1,0.5,0],"intensity":4}]}},
"nodes":[{"mesh":0,"translation":[0,0,-5]},{"camera":0,"translation":[0,0,3]},
{"translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}}}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.7853981634,"aspectRatio":2,"znear":0.1}}],
"materials":[{"name":"metal","pbrMetallicRoughness":{"baseColorFactor":[0.8,0.4,0.2,1],
"metallicFactor":0.75,"roughnessFactor":0.5}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],
"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

std::string notesOf(const ImportedScene& scene) {
  std::string notes;
  for (const std::string& note : scene.notes) notes += note + "\n";
  return notes;
}

/// Writes the scene beside its file and reads it.
Scene readBack(const test::TemporaryDirectory& directory, const ImportedScene& scene) {
  test::writeBytes(directory.file("back.toml"), sceneText(scene, directory.path()));
  return readScene(directory.file("back.toml"));
}

}  // namespace

TEST_CASE("importScene takes an OBJ's materials, each as an object", "[import]") {
  const test::TemporaryDirectory directory;
  test::writeBytes(directory.file("a.mtl"),
                   "newmtl red \"one\"\nKd 0.5 0 0\nKs 0.25 0.25 0.25\nNs 100\n"
                   "newmtl lamp\nKd 0 0 0\nKe 3 2 1\n");
  test::writeBytes(
      directory.file("a.obj"),
      "mtllib a.mtl\n" + kCorners + "usemtl red \"one\"\nf 1 2 3\nf 1 2 4\nusemtl lamp\nf 2 3 4\n");
  const ImportedScene imported = importScene(directory.file("a.obj"));
  CHECK(imported.triangleCount == 3);
  const Scene scene = readBack(directory, imported);
  REQUIRE(scene.objects.size() == 2);
  REQUIRE(scene.materials.size() == 2);
  const auto materialOf = [&](std::size_t object) {
    return scene.materials[static_cast<std::size_t>(scene.objects[object].material)];
  };
  CHECK(materialOf(0).name == "red \"one\"");
  CHECK(materialOf(0).albedo == glm::vec3(0.5f, 0, 0));
  CHECK(materialOf(0).specular == glm::vec3(0.25f));
  CHECK(materialOf(0).exponent == 100.0f);
  CHECK(materialOf(1).emission == glm::vec3(3, 2, 1));
  const FlatScene flat = flatten(scene, scene.render);
  CHECK(flat.primitiveObject == std::vector<int>{0, 0, 1});
  // The lamp is light enough.
  CHECK(scene.environment.radiance == glm::vec3(0.0f));
}

TEST_CASE("importScene gives a PLY without light and camera both", "[import]") {
  const test::TemporaryDirectory directory;
  test::writeBytes(directory.file("a.ply"),
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                   "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const ImportedScene scene = importScene(directory.file("a.ply"));
  CHECK(scene.background == glm::vec3(0.5f));
  REQUIRE(scene.lights.size() == 1);
  CHECK(std::holds_alternative<SunLight>(scene.lights[0]));
  CHECK(scene.camera.target == glm::vec3(0.5f, 0.5f, 0.0f));
  CHECK_THAT(notesOf(scene), Contains("no light: a sun and a grey environment are added") &&
                                 Contains("no camera: this one sees all of it from the front"));
  CHECK(readBack(directory, scene).objects.size() == 1);
}

TEST_CASE("importScene takes a glTF's camera, light and material", "[import]") {
  const test::TemporaryDirectory directory;
  test::writeBytes(directory.file("a.gltf"), kGltf);
  const ImportedScene scene = importScene(directory.file("a.gltf"));
  CHECK(scene.camera.eye == glm::vec3(0, 0, 3));
  const glm::dvec3 ahead = glm::normalize(glm::dvec3(scene.camera.target - scene.camera.eye));
  CHECK(ahead.z == Approx(-1.0));
  CHECK(scene.camera.up == glm::vec3(0, 1, 0));
  CHECK(scene.camera.fov == Approx(45.0));
  CHECK(scene.width == 1024);
  CHECK(scene.height == 512);
  REQUIRE(scene.parts.size() == 1);
  const Material& metal = scene.parts[0].material;
  CHECK(metal.name == "metal");
  CHECK(metal.albedo.r == Approx(0.2));
  CHECK(metal.specular.r == Approx(0.6));
  CHECK(metal.roughness == 0.5f);
  CHECK(metal.lobe == Lobe::ggx);
  REQUIRE(scene.lights.size() == 1);
  const auto light = std::get<PointLight>(scene.lights[0]);
  CHECK(light.position == glm::vec3(1, 2, 3));
  CHECK(light.intensity == glm::vec3(4, 2, 0));
  const Scene back = readBack(directory, scene);
  CHECK(back.camera.fov == scene.camera.fov);
}

TEST_CASE("importScene says what is wrong with a file that is no model", "[import]") {
  const test::TemporaryDirectory directory;
  test::writeBytes(directory.file("a.txt"), "hello");
  CHECK_THROWS_AS(importScene(directory.file("a.txt")), FileError);
  CHECK_THROWS_WITH(importScene(directory.file("a.txt")),
                    Contains("expected one that ends in .obj, .ply, .gltf, .glb or .nff"));
  test::writeBytes(directory.file("a.gltf"), "{");
  CHECK_THROWS_AS(importScene(directory.file("a.gltf")), FileError);
  test::writeBytes(directory.file("points.obj"), kCorners);
  CHECK_THROWS_AS(importScene(directory.file("points.obj")), FileError);
  test::writeBytes(directory.file("nan.obj"), "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK_THROWS_WITH(
      importScene(directory.file("nan.obj")),
      directory.file("nan.obj") + ": found 1 vertex in '" + directory.file("nan.obj") +
          "' with coordinates that are not finite or beyond 1e18, expected finite ones");
  CHECK_THROWS_AS(importScene(directory.file("none.obj")), IoError);
}
