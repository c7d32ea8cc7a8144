#include "common/scene/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "common/base/wording.h"
#include "common/generate/parts.h"
#include "common/scene/scene.h"

namespace twintrace {

namespace {

bool anyPositive(const glm::vec3& color) {
  return color.x > 0 || color.y > 0 || color.z > 0;
}

Effect effectOf(const SphereShape&) {
  return Effect::sphere;
}
Effect effectOf(const BoxShape& box) {
  return box.isTurned() ? Effect::orientedBox : Effect::box;
}
Effect effectOf(const PlaneShape&) {
  return Effect::plane;
}
/// The effects of what an object consists of.
EffectSet effectsOf(const Parts& parts, bool smooth) {
  EffectSet effects;
  if (!parts.spheres.empty()) effects.set(Effect::sphere, true);
  for (const BoxShape& box : parts.boxes) effects.set(effectOf(box), true);
  if (!parts.mesh.triangles.empty()) {
    effects.set(Effect::triangle, true);
    effects.set(Effect::smooth, smooth);
  }
  return effects;
}

EffectSet effectsOf(const MeshShape& mesh) {
  return effectsOf(*mesh.parts, mesh.smooth);
}
EffectSet effectsOf(const GeneratedShape& generated) {
  return effectsOf(*generated.parts, false);
}
template <class Shape>
EffectSet effectsOf(const Shape& shape) {
  EffectSet effects;
  effects.set(effectOf(shape), true);
  return effects;
}

EffectSet effectsOf(const Object& object) {
  return std::visit([](const auto& shape) { return effectsOf(shape); }, object.shape);
}

/// The parts of which these effects leave some.
std::shared_ptr<const Parts> withoutEffects(const std::shared_ptr<const Parts>& parts,
                                            const EffectSet& effects) {
  auto left = std::make_shared<Parts>(*parts);
  if (!effects.has(Effect::sphere)) left->spheres.clear();
  std::erase_if(left->boxes, [&](const BoxShape& box) { return !effects.has(effectOf(box)); });
  if (!effects.has(Effect::triangle)) left->mesh = {};
  return left;
}

void leaveOut(Object& object, const EffectSet& effects) {
  if ((effectsOf(object).bits() & ~effects.bits()) == 0) return;
  if (auto* mesh = std::get_if<MeshShape>(&object.shape)) {
    mesh->parts = withoutEffects(mesh->parts, effects);
    mesh->smooth = mesh->smooth && effects.has(Effect::smooth);
  } else if (auto* generated = std::get_if<GeneratedShape>(&object.shape)) {
    generated->parts = withoutEffects(generated->parts, effects);
  }
}

Effect effectOf(const PointLight&) {
  return Effect::pointLight;
}
Effect effectOf(const SphereLight&) {
  return Effect::sphereLight;
}
Effect effectOf(const SunLight&) {
  return Effect::sunLight;
}

void addSpecular(const Material& material, EffectSet& effects) {
  if (!anyPositive(material.specular)) return;
  if (material.roughness < kMirrorRoughness) {
    effects.set(Effect::mirror, true);
  } else {
    effects.set(material.lobe == Lobe::ggx ? Effect::ggx : Effect::phong, true);
  }
}

void addMaterial(const Material& material, EffectSet& effects) {
  if (anyPositive(material.emission)) effects.set(Effect::emission, true);
  if (anyPositive(material.albedo)) effects.set(Effect::diffuse, true);
  addSpecular(material, effects);
}

void addObjects(const Scene& scene, EffectSet& effects) {
  for (const Object& object : scene.objects) {
    effects.add(effectsOf(object));
    addMaterial(scene.materials.at(static_cast<std::size_t>(object.material)), effects);
  }
}

void addLights(const Scene& scene, EffectSet& effects) {
  for (const Light& light : scene.lights) {
    effects.set(std::visit([](const auto& kind) { return effectOf(kind); }, light), true);
  }
}

bool followsPaths(Integrator integrator) {
  return integrator != Integrator::local;
}

void applyForced(const Scene& scene, EffectSet& effects) {
  for (const auto& [name, on] : scene.forcedEffects) {
    const std::optional<Effect> effect = effectFromName(name);
    if (!effect) throw UsageError("found effect " + quote(name) + ", expected a known effect");
    effects.set(*effect, on);
  }
}

/// Every branch compiled in, save those that the scene forbids: compiling them in would change the
/// picture and not only its cost.
EffectSet allAllowed(const Scene& scene) {
  EffectSet effects = EffectSet::all();
  applyForced(scene, effects);
  return effects;
}

}  // namespace

std::optional<Effect> effectFromName(std::string_view name) {
  const auto found = std::find(kEffectNames.begin(), kEffectNames.end(), name);
  if (found == kEffectNames.end()) return std::nullopt;
  return static_cast<Effect>(found - kEffectNames.begin());
}

EffectSet effectsFromList(std::string_view list) {
  const std::vector<std::string> known(kEffectNames.begin(), kEffectNames.end());
  EffectSet effects;
  while (true) {
    const std::size_t comma = list.find(',');
    const std::string_view name = list.substr(0, comma);
    const std::optional<Effect> effect = effectFromName(name);
    if (!effect) {
      throw UsageError(
          fmt::format("found effect {}, expected auto, all or a comma-separated list of {}{}",
                      quote(name), oneOf(known), didYouMean(name, known)));
    }
    effects.set(*effect, true);
    if (comma == std::string_view::npos) return effects;
    list.remove_prefix(comma + 1);
  }
}

EffectSet neededEffects(const Scene& scene, const RenderOptions& options) {
  EffectSet effects;
  addObjects(scene, effects);
  addLights(scene, effects);
  effects.set(Effect::environmentImage, !scene.environment.image.empty());
  effects.set(Effect::lens, scene.camera.aperture > 0);
  effects.set(Effect::indirect, followsPaths(options.integrator) && options.bounces > 1);
  applyForced(scene, effects);
  return effects;
}

Scene withoutEffects(Scene scene, const EffectSet& effects) {
  const auto off = [&](Effect effect) { return !effects.has(effect); };
  for (Material& material : scene.materials) {
    if (off(Effect::emission)) material.emission = glm::vec3(0.0f);
    if (off(Effect::diffuse)) material.albedo = glm::vec3(0.0f);
    EffectSet specular;
    addSpecular(material, specular);
    if ((specular.bits() & ~effects.bits()) != 0) material.specular = glm::vec3(0.0f);
  }
  std::erase_if(scene.lights, [&](const Light& light) {
    return off(std::visit([](const auto& kind) { return effectOf(kind); }, light));
  });
  for (Object& object : scene.objects) leaveOut(object, effects);
  std::erase_if(scene.objects, [&](const Object& object) {
    return (effectsOf(object).bits() & effects.bits()) == 0;
  });
  if (off(Effect::lens)) scene.camera.aperture = 0.0f;
  return scene;
}

EffectSet chosenEffects(const Scene& scene, const RenderOptions& options) {
  if (options.effects == "auto") return neededEffects(scene, options);
  if (options.effects == "all") return allAllowed(scene);
  return effectsFromList(options.effects);
}

}  // namespace twintrace
