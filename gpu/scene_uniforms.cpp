#include "gpu/scene_uniforms.h"

#include "common/hulls/hull_structure.h"
#include "gpu/specialisation.h"

namespace twintrace {
namespace {

constexpr std::uint32_t kSceneUnit = 0;
constexpr std::uint32_t kHullUnit = 2;  // 1 holds the rays of cases

}  // namespace

void setSceneUniforms(Program& program, const FlatScene& scene, const RenderOptions& options) {
  const FlatCamera& camera = scene.camera;
  program.set("sceneTexels", static_cast<std::int32_t>(kSceneUnit));
  program.set("hullTexels", static_cast<std::int32_t>(kHullUnit));
  if (scene.hulls != nullptr) program.set("hullReach", scene.hulls->reach);
  program.set("cameraOrigin", camera.origin);
  program.set("cameraCorner", camera.corner);
  program.set("cameraStepX", camera.stepX);
  program.set("cameraStepY", camera.stepY);
  program.set("cameraLensX", camera.lensX);
  program.set("cameraLensY", camera.lensY);
  program.set("environmentRadiance", scene.environmentRadiance);
  program.set("environmentTurn", scene.environmentTurn);
  if (usesUniformIndex(scene, options)) {
    for (const auto& [name, value] : indexConstants(scene)) program.set(name, value);
  }
}

SceneTextures::SceneTextures(Context& context, const FlatScene& scene)
    : texels_(context, scene.texels) {
  if (scene.hulls != nullptr) hulls_.emplace(context, scene.hulls->texels);
}

void SceneTextures::bind() const {
  texels_.bind(kSceneUnit);
  if (hulls_) hulls_->bind(kHullUnit);
}

}  // namespace twintrace
