#include "common/scene/effects.h"

#include <string>
#include <utility>

#include "common/scene/scene.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

EffectSet setOf(std::initializer_list<Effect> effects) {
  EffectSet set;
  for (const Effect effect : effects) set.set(effect, true);
  return set;
}

Scene sceneWith(Material material) {
  Scene scene;
  scene.render.bounces = 1;
  scene.materials.push_back(std::move(material));
  scene.objects.push_back({"ball", SphereShape{}, 0});
  return scene;
}

Material glossy(float roughness, Lobe lobe) {
  Material material;
  material.specular = glm::vec3(0.0f, 0.0f, 0.5f);
  material.roughness = roughness;
  material.lobe = lobe;
  return material;
}

EffectSet needed(const Scene& scene) {
  return neededEffects(scene, scene.render);
}

TEST_CASE("effectFromName finds every name and nothing else", "[effects]") {
  for (int i = 0; i < kEffectCount; ++i) {
    CHECK(effectFromName(kEffectNames[static_cast<std::size_t>(i)]) == static_cast<Effect>(i));
  }
  CHECK_FALSE(effectFromName(""));
  CHECK_FALSE(effectFromName("Sphere"));
}

TEST_CASE("neededEffects of an empty scene is empty", "[effects]") {
  Scene scene;
  scene.render.bounces = 1;
  CHECK(needed(scene) == EffectSet());
}

TEST_CASE("neededEffects has the shapes of the objects", "[effects]") {
  Scene scene = sceneWith(Material{});
  CHECK(needed(scene) == setOf({Effect::sphere}));
  scene.objects[0].shape = BoxShape{};
  CHECK(needed(scene) == setOf({Effect::box}));
  scene.objects[0].shape = BoxShape{{}, glm::vec3(1.0f), glm::vec3(0.0f, 1.0f, 0.0f)};
  CHECK(needed(scene) == setOf({Effect::orientedBox}));
  scene.objects[0].shape = PlaneShape{};
  CHECK(needed(scene) == setOf({Effect::plane}));
}

TEST_CASE("neededEffects has the lobes and emission of used materials", "[effects]") {
  Material diffuse;
  diffuse.albedo = glm::vec3(0.0f, 0.5f, 0.0f);
  CHECK(needed(sceneWith(diffuse)) == setOf({Effect::sphere, Effect::diffuse}));
  Material lamp;
  lamp.emission = glm::vec3(0.0f, 0.0f, 1.0f);
  CHECK(needed(sceneWith(lamp)) == setOf({Effect::sphere, Effect::emission}));
  CHECK(needed(sceneWith(glossy(0.0f, Lobe::phong))) == setOf({Effect::sphere, Effect::mirror}));
  CHECK(needed(sceneWith(glossy(0.5f, Lobe::ggx))) == setOf({Effect::sphere, Effect::ggx}));
  CHECK(needed(sceneWith(glossy(0.5f, Lobe::phong))) == setOf({Effect::sphere, Effect::phong}));
}

TEST_CASE("neededEffects ignores materials that no object uses", "[effects]") {
  Scene scene = sceneWith(Material{});
  scene.materials.push_back(glossy(0.0f, Lobe::ggx));
  CHECK(needed(scene) == setOf({Effect::sphere}));
}

TEST_CASE("neededEffects has the lights, the environment image and the lens", "[effects]") {
  Scene scene;
  scene.render.bounces = 1;
  scene.lights = {PointLight{}, SunLight{}};
  CHECK(needed(scene) == setOf({Effect::pointLight, Effect::sunLight}));
  scene.lights = {SphereLight{}};
  CHECK(needed(scene) == setOf({Effect::sphereLight}));
  scene.lights.clear();
  scene.environment.image = "sky.exr";
  CHECK(needed(scene) == setOf({Effect::environmentImage}));
  scene.environment.image.clear();
  scene.camera.aperture = 0.1f;
  CHECK(needed(scene) == setOf({Effect::lens}));
}

TEST_CASE("neededEffects has indirect light from two bounces on, but not in local", "[effects]") {
  const Scene scene;
  RenderOptions options;
  options.bounces = 2;
  for (const Integrator integrator : {Integrator::path, Integrator::report, Integrator::whitted}) {
    options.integrator = integrator;
    CHECK(neededEffects(scene, options).has(Effect::indirect));
  }
  options.integrator = Integrator::local;
  CHECK_FALSE(neededEffects(scene, options).has(Effect::indirect));
  options.integrator = Integrator::path;
  options.bounces = 1;
  CHECK_FALSE(neededEffects(scene, options).has(Effect::indirect));
}

TEST_CASE("neededEffects follows [effects] in both directions", "[effects]") {
  Scene scene = sceneWith(Material{});
  scene.forcedEffects = {{"sphere", false}, {"lens", true}};
  CHECK(needed(scene) == setOf({Effect::lens}));
}

TEST_CASE("chosenEffects is what is needed, all that is allowed, or a list", "[effects]") {
  Scene scene = sceneWith(Material{});
  scene.forcedEffects = {{"lens", false}};
  RenderOptions options = scene.render;
  CHECK(chosenEffects(scene, options) == needed(scene));
  options.effects = "all";
  EffectSet allButLens = EffectSet::all();
  allButLens.set(Effect::lens, false);
  CHECK(chosenEffects(scene, options) == allButLens);
  options.effects = "box,lens";
  CHECK(chosenEffects(scene, options) == setOf({Effect::box, Effect::lens}));
}

TEST_CASE("chosenEffects reports a name that is no effect", "[effects]") {
  RenderOptions options;
  for (const char* list : {"", "box,", ",", "box, lens", "fog"}) {
    options.effects = list;
    CHECK_THROWS_AS(chosenEffects(Scene{}, options), UsageError);
  }
}

}  // namespace
}  // namespace twintrace
