#include "common/scene/flat_scene.h"

#include <bit>
#include <memory>

#include "common/generate/parts.h"
#include "common/scene/layout.h"
#include "common/scene/reader.h"
#include "tests/catch.h"

using namespace twintrace;

namespace {

constexpr const char* kMaterials = R"(
[materials.white]
albedo = [0.5, 0.5, 0.5]
specular = [0.2, 0.2, 0.2]
[materials.lamp]
emission = [1.0, 1.0, 1.0]
)";

Scene sceneOf(const std::string& text) {
  return parseScene(kMaterials + text, "test.toml");
}

float component(const FlatScene& flat, int texel, int i) {
  return std::bit_cast<float>(flat.texels[static_cast<std::size_t>(texel)][i]);
}

}  // namespace

TEST_CASE("flatten keeps the faces of a box as they were authored", "[unit]") {
  const Scene scene = sceneOf(R"(
[[objects]]
shape = "box"
min = [1e6, -0.1, 0.3]
max = [1000000.0625, 0.7, 16777215.0]
material = "white"
)");
  const FlatScene flat = flatten(scene, scene.render);
  const int box = flat.index.boxOffset;
  CHECK(component(flat, box, 0) == 1e6f);
  CHECK(component(flat, box, 1) == -0.1f);
  CHECK(component(flat, box, 2) == 0.3f);
  CHECK(component(flat, box + 1, 0) == 1000000.0625f);
  CHECK(component(flat, box + 1, 1) == 0.7f);
  CHECK(component(flat, box + 1, 2) == 16777215.0f);
}

TEST_CASE("flatten takes a rotation by nothing for an aligned box, as the effects do", "[unit]") {
  const Scene scene = sceneOf(R"(
[[objects]]
shape = "box"
center = [0, 0, 0]
size = [1, 1, 1]
rotation = [0, 0, 0]
material = "white"
)");
  const FlatScene flat = flatten(scene, scene.render);
  CHECK(flat.index.boxCount == 1);
  CHECK(flat.effects.has(Effect::box));
  CHECK_FALSE(flat.effects.has(Effect::orientedBox));
}

TEST_CASE("flatten gives triangles of smooth meshes their vertices' normals", "[unit]") {
  auto parts = std::make_shared<Parts>();
  parts->mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 5}};
  parts->mesh.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
  parts->mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
  MeshShape mesh;
  mesh.parts = parts;
  Scene scene = sceneOf("");
  scene.objects.push_back({"flat", mesh, 0});
  mesh.smooth = true;
  scene.objects.push_back({"smooth", mesh, 1});
  const FlatScene flat = flatten(scene, scene.render);
  REQUIRE(flat.index.triangleCount == 4);
  REQUIRE(flat.index.smoothCount == 2);
  CHECK(flat.primitiveObject == std::vector<int>{0, 0, 1, 1});
  // The last triangle, from (1, 0, 0) by (0, 1, 0) to (0, 0, 5), and the record of its normals.
  const int last = flat.index.triangleOffset + 3 * layout::kTriangleTexels;
  CHECK(component(flat, last, 0) == 1.0f);
  CHECK(component(flat, last + 1, 1) == 1.0f);
  CHECK(component(flat, last + 2, 2) == 5.0f);
  const auto recordOf = [&](int triangle) {
    return flat.texels[flat.index.triangleOffset + triangle * layout::kTriangleTexels].w;
  };
  CHECK(recordOf(0) == 0u);
  CHECK(recordOf(1) == 0u);
  CHECK(recordOf(2) == 1u);
  CHECK(recordOf(3) == 2u);
  const int normals = flat.index.smoothOffset + layout::kSmoothTexels;
  CHECK(component(flat, normals, 1) == 1.0f);
  CHECK(component(flat, normals + 1, 2) == 1.0f);
  CHECK(component(flat, normals + 2, 0) == -1.0f);
}

TEST_CASE("flatten puts the parts of a generated object among the primitives of each kind",
          "[unit]") {
  auto parts = std::make_shared<Parts>();
  parts->spheres.push_back({{1, 2, 3}, 4.0f});
  parts->boxes.push_back({{0, 0, 0}, {2, 2, 2}, {}});
  parts->boxes.push_back({{0, 0, 0}, {2, 2, 2}, glm::vec3(30.0f)});
  parts->mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  parts->mesh.triangles = {{0, 1, 2}};
  GeneratedShape generated;
  generated.parts = parts;
  Scene scene = sceneOf("");
  scene.objects.push_back({"plane", PlaneShape{}, 0});
  scene.objects.push_back({"ball", SphereShape{}, 0});
  scene.objects.push_back({"mixed", generated, 1});
  const FlatScene flat = flatten(scene, scene.render);
  CHECK(flat.index.sphereCount == 2);
  CHECK(flat.index.boxCount == 1);
  CHECK(flat.index.orientedBoxCount == 1);
  CHECK(flat.index.triangleCount == 1);
  CHECK(flat.index.planeCount == 1);
  CHECK(flat.index.smoothCount == 0);
  CHECK(flat.primitiveObject == std::vector<int>{1, 2, 2, 2, 2, 0});
  for (const Effect effect : {Effect::sphere, Effect::box, Effect::orientedBox, Effect::triangle}) {
    CHECK(flat.effects.has(effect));
  }
  CHECK_FALSE(flat.effects.has(Effect::smooth));
}

TEST_CASE("flatten leaves out what the effects forbid", "[unit]") {
  const Scene scene = sceneOf(R"(
[camera]
eye = [0, 0, 5]
aperture = 0.5
[effects]
diffuse = false
mirror = false
emission = false
pointLight = false
lens = false
plane = false
[[objects]]
shape = "sphere"
center = [0, 0, 0]
radius = 1
material = "white"
[[objects]]
shape = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "lamp"
[[lights]]
kind = "point"
position = [0, 1, 0]
intensity = [1, 1, 1]
)");
  const FlatScene flat = flatten(scene, scene.render);
  CHECK(flat.index.planeCount == 0);
  CHECK(flat.index.lightCount == 0);
  CHECK(flat.camera.lensX == glm::vec3(0.0f));
  for (int texel = flat.index.materialOffset; texel < flat.index.lightOffset; texel += 7) {
    for (int i = 0; i < 3; ++i) {
      CHECK(component(flat, texel, i) == 0.0f);
      CHECK(component(flat, texel + 1, i) == 0.0f);
    }
  }
}

TEST_CASE("flatten reduces the environment's rotation before rounding it", "[unit]") {
  Scene scene = parseScene("", "test.toml");
  scene.environment.image = TWINTRACE_SOURCE_DIR "/experiments/scenes/sky.exr";
  scene.environment.rotation = 3.6e9f + 512.0f;
  const FlatScene flat = flatten(scene, scene.render);
  CHECK(flat.environmentTurn >= 0.0f);
  CHECK(flat.environmentTurn <= 1.0f);
}
