#include "experiments/probe/worlds.h"

#include <bit>
#include <memory>
#include <utility>

#include "common/cast/case_texels.h"
#include "common/generate/parts.h"
#include "common/hulls/hull_structure.h"
#include "common/mesh/load_mesh.h"
#include "common/scene/reader.h"

namespace twintrace::probe {
namespace {

// Every kind of primitive, lobe and light, near the origin, where random rays meet them.
constexpr const char* kScene = R"toml(
name = "probe"
[film]
width = 48
height = 32
[camera]
eye = [0.3, 1.1, 3.2]
target = [0.0, 0.1, 0.0]
fov = 50.0
aperture = 0.05
focus = 3.0
[materials.white]
albedo = [0.7, 0.6, 0.5]
ambient = [0.1, 0.1, 0.2]
highlight = [0.3, 0.2, 0.1]
exponent = 20.0
[materials.mirror]
specular = [0.9, 0.8, 0.9]
[materials.rough]
albedo = [0.2, 0.3, 0.2]
specular = [0.5, 0.4, 0.5]
roughness = 0.4
highlight = [0.5, 0.5, 0.5]
[materials.gloss]
albedo = [0.1, 0.2, 0.3]
specular = [0.6, 0.6, 0.5]
roughness = 0.3
lobe = "phong"
[materials.lamp]
emission = [4.0, 3.0, 2.0]
[[objects]]
name = "ball"
shape = "sphere"
center = [-0.8, 0.1, 0.2]
radius = 0.6
material = "rough"
[[objects]]
name = "marble"
shape = "sphere"
center = [0.4, -0.3, 1.0]
radius = 0.3
material = "mirror"
[[objects]]
name = "crate"
shape = "box"
center = [0.9, 0.0, -0.3]
size = [0.8, 1.0, 0.7]
material = "gloss"
[[objects]]
name = "lamp"
shape = "box"
min = [-0.5, 1.6, -0.5]
max = [0.5, 1.7, 0.5]
material = "lamp"
[[objects]]
name = "leaning"
shape = "box"
center = [0.0, 0.2, -1.2]
size = [0.9, 1.3, 0.3]
rotation = [20.0, 35.0, -10.0]
material = "white"
[[objects]]
name = "floor"
shape = "plane"
point = [0.0, -0.6, 0.0]
normal = [0.02, 1.0, -0.01]
material = "white"
[[lights]]
kind = "point"
position = [1.5, 1.9, 1.0]
intensity = [2.0, 1.5, 1.0]
[[lights]]
kind = "sphere"
position = [-1.6, 1.4, 1.2]
radius = 0.25
intensity = [1.0, 2.0, 1.5]
[[lights]]
kind = "sun"
direction = [0.4, -1.0, -0.3]
irradiance = [0.6, 0.6, 0.5]
angle = 0.6
)toml";

constexpr int kImageWidth = 16;
constexpr int kImageHeight = 8;

// An environment image without a file: smooth, all channels different.
void addEnvironment(FlatScene& scene) {
  scene.index.environmentOffset = static_cast<int>(scene.texels.size());
  scene.index.environmentWidth = kImageWidth;
  scene.index.environmentHeight = kImageHeight;
  scene.environmentRadiance = {0.25f, 0.375f, 0.5f};
  scene.environmentTurn = 0.3125f;
  for (int y = 0; y < kImageHeight; ++y) {
    for (int x = 0; x < kImageWidth; ++x) {
      const float red = 0.1f + 0.05f * static_cast<float>(x);
      const float green = 0.9f / static_cast<float>(y + 1);
      scene.texels.emplace_back(std::bit_cast<std::uint32_t>(red), std::bit_cast<std::uint32_t>(green),
                                std::bit_cast<std::uint32_t>(red * green), 0u);
    }
  }
}

// A pyramid about `top`, of three triangles that share it.
Mesh pyramid(const glm::vec3& top) {
  Mesh mesh;
  mesh.positions = {top, top + glm::vec3(-0.4f, -0.7f, 0.3f), top + glm::vec3(0.5f, -0.6f, 0.2f),
                    top + glm::vec3(0.1f, -0.8f, -0.5f)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  addNormals(mesh);
  return mesh;
}

// A mesh without a file, for the scene's first material.
void addMesh(Scene& scene, const std::string& name, const glm::vec3& top, bool smooth) {
  Parts parts;
  parts.mesh = pyramid(top);
  MeshShape shape;
  shape.smooth = smooth;
  shape.parts = std::make_shared<const Parts>(std::move(parts));
  Object object;
  object.name = name;
  object.shape = shape;
  scene.objects.push_back(object);
}

// One primitive of each kind near the origin, again and again, a little further along x.
void addCases(FlatScene& scene) {
  const CasePrimitive kinds[] = {
      {CaseKind::sphere, {-0.6f, 0.1f, 0.2f, 0.7f}},
      {CaseKind::box, {-0.5f, -0.4f, -0.6f, 0.3f, 0.5f, 0.4f}},
      {CaseKind::orientedBox,
       {0.1f, 0.2f, -0.3f, 0.8f, 0.6f, 0.0f, -0.6f, 0.8f, 0.0f, 0.0f, 0.0f, 1.0f, 0.5f, 0.3f, 0.4f}},
      {CaseKind::plane, {0.02f, 1.0f, -0.01f, 0.0f, -0.6f, 0.0f}},
      {CaseKind::triangle, {-0.9f, -0.7f, 0.1f, 0.8f, -0.5f, -0.2f, 0.1f, 0.9f, 0.3f}}};
  CaseSet cases;
  for (int i = 0; i < kWorldCases; ++i) {
    CasePrimitive primitive = kinds[i % 5];
    primitive.values[0] += 0.25f * static_cast<float>(i / 5);
    cases.primitives.push_back(normalised(primitive));
  }
  const CaseTexels packed = packCases(cases);
  scene.texels.insert(scene.texels.end(), packed.texels.begin(), packed.texels.end());
}

// Hulls of all the slabs there are, in a tree: records of every volume can be read from them.
std::shared_ptr<const HullStructure> hullsOf(const FlatScene& scene) {
  const HullStrategy* slabs = findHullStrategy("kdop26");
  HullStrategy strategy{"probe", "", HullArrangement::tree, HullGrouping::sah, slabs->volume};
  return std::make_shared<const HullStructure>(buildHulls(scene, strategy));
}

World makeWorld(const std::string& name, const RenderOptions& options) {
  World world;
  world.name = name;
  world.options = options;
  world.options.effects = "all";
  Scene scene = parseScene(kScene, "probe.toml");
  addMesh(scene, "facets", {-0.2f, 0.9f, 0.7f}, false);
  addMesh(scene, "cloth", {0.7f, 0.8f, 0.6f}, true);
  world.scene = flatten(scene, world.options);
  addEnvironment(world.scene);
  addCases(world.scene);
  if (options.geometry != Geometry::literal) world.scene.hulls = hullsOf(world.scene);
  world.view = kernel::viewScene(world.scene, world.options, nullptr);
  return world;
}

RenderOptions plainOptions() {
  RenderOptions options;
  options.width = 48;
  options.height = 32;
  options.geometry = Geometry::buffer;
  options.intersector = Intersector::robust;
  return options;
}

}  // namespace

World plainWorld() {
  return makeWorld("plain", plainOptions());
}

World sceneWorld(const FlatScene& scene, const RenderOptions& options) {
  World world;
  world.name = "scene";
  world.options = options;
  world.options.geometry = Geometry::buffer;
  world.scene = scene;
  world.view = kernel::viewScene(world.scene, world.options, nullptr);
  return world;
}

std::vector<World> worldsFor(const ShaderFunction& function) {
  std::vector<World> worlds;
  worlds.push_back(plainWorld());
  const auto add = [&worlds](const std::string& name, auto member, auto value) {
    RenderOptions options = plainOptions();
    options.*member = value;
    worlds.push_back(makeWorld(name, options));
  };
  const Needs& needs = function.needs;
  if (needs.noise) add("noise sine", &RenderOptions::noise, Noise::sine);
  if (needs.intersector) {
    add("intersector report", &RenderOptions::intersector, Intersector::report);
  }
  if (needs.geometry) add("geometry literal", &RenderOptions::geometry, Geometry::literal);
  if (needs.integrator) {
    add("integrator local", &RenderOptions::integrator, Integrator::local);
    add("integrator whitted", &RenderOptions::integrator, Integrator::whitted);
    add("integrator report", &RenderOptions::integrator, Integrator::report);
  }
  return worlds;
}

}  // namespace twintrace::probe
