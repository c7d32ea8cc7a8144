#pragma once

// What the kernel sees of a flat scene and of the options. Where the shaders are specialised by
// constants, the kernel reads these flags: they are the same for all rays, so that their branches
// cost next to nothing.

#include "common/hulls/hull_structure.h"
#include "common/scene/flat_scene.h"
#include "cpu/hull_query.h"
#include "cpu/kernel/records.h"

TWINTRACE_KERNEL_BEGIN

/// The scene's hulls; without texels if it has none.
struct HullView {
  const glm::uvec4* texels = nullptr;
  int groups = 1;  ///< of slabs in a k-DOP
  int nodeTexels = 0;
  int nodeCount = 0;
  int referenceOffset = 0;
  float reach = 0.0f;  ///< largest coordinate of what the hulls contain
};

struct SceneView {
  const std::uint32_t* words = nullptr;  ///< texels as 32-bit words
  HullView hulls;
  SceneIndex index;
  Camera<float> camera;
  Vec3<float> environmentRadiance;
  float environmentTurn = 0.0f;
  const HullQuery* hull = nullptr;  ///< null: every primitive is tested

  Integrator integrator = Integrator::path;
  bool intersectorReport = false;
  bool noiseSine = false;
  bool effectSphere = true;
  bool effectBox = true;
  bool effectOrientedBox = true;
  bool effectTriangle = true;
  bool effectSmooth = true;
  bool effectPlane = true;
  bool effectEmission = true;
  bool effectDiffuse = true;
  bool effectMirror = true;
  bool effectGgx = true;
  bool effectPhong = true;
  bool effectEnvironmentImage = true;
  bool effectPointLight = true;
  bool effectSphereLight = true;
  bool effectSunLight = true;
  bool effectLens = true;
  bool effectIndirect = true;

  bool effectAnyLight() const { return effectPointLight || effectSphereLight || effectSunLight; }
};

inline Vec3<float> toVec3(const glm::vec3& v) { return {v.x, v.y, v.z}; }

inline HullView viewHulls(const HullStructure& hulls) {
  return {hulls.texels.data(), hulls.volume.groups,    hulls.nodeTexels,
          hulls.nodeCount,     hulls.referenceOffset, hulls.reach};
}

/// The view of a flat scene; `hull` may be null.
inline SceneView viewScene(const FlatScene& scene, const RenderOptions& options,
                           const HullQuery* hull) {
  const FlatCamera& camera = scene.camera;
  const auto has = [&](Effect effect) { return scene.effects.has(effect); };
  SceneView view;
  view.words = &scene.texels[0].x;
  if (scene.hulls != nullptr) view.hulls = viewHulls(*scene.hulls);
  view.index = scene.index;
  view.camera = {toVec3(camera.origin), toVec3(camera.corner), toVec3(camera.stepX),
                 toVec3(camera.stepY),  toVec3(camera.lensX),  toVec3(camera.lensY)};
  view.environmentRadiance = toVec3(scene.environmentRadiance);
  view.environmentTurn = scene.environmentTurn;
  view.hull = hull;
  view.integrator = options.integrator;
  view.intersectorReport = options.intersector == Intersector::report;
  view.noiseSine = options.noise == Noise::sine;
  view.effectSphere = has(Effect::sphere);
  view.effectBox = has(Effect::box);
  view.effectOrientedBox = has(Effect::orientedBox);
  view.effectTriangle = has(Effect::triangle);
  view.effectSmooth = has(Effect::smooth);
  view.effectPlane = has(Effect::plane);
  view.effectEmission = has(Effect::emission);
  view.effectDiffuse = has(Effect::diffuse);
  view.effectMirror = has(Effect::mirror);
  view.effectGgx = has(Effect::ggx);
  view.effectPhong = has(Effect::phong);
  view.effectEnvironmentImage = has(Effect::environmentImage);
  view.effectPointLight = has(Effect::pointLight);
  view.effectSphereLight = has(Effect::sphereLight);
  view.effectSunLight = has(Effect::sunLight);
  view.effectLens = has(Effect::lens);
  view.effectIndirect = has(Effect::indirect);
  return view;
}

TWINTRACE_KERNEL_END
