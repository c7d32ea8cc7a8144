#include "gpu/scene_uniforms.h"

#include "gpu/specialisation.h"

namespace twintrace {

void setSceneUniforms(Program& program, const FlatScene& scene, const RenderOptions& options) {
  const FlatCamera& camera = scene.camera;
  program.set("sceneTexels", 0);
  program.set("cameraOrigin", camera.origin);
  program.set("cameraCorner", camera.corner);
  program.set("cameraStepX", camera.stepX);
  program.set("cameraStepY", camera.stepY);
  program.set("cameraLensX", camera.lensX);
  program.set("cameraLensY", camera.lensY);
  program.set("environmentRadiance", scene.environmentRadiance);
  program.set("environmentTurn", scene.environmentTurn);
  if (usesUniformIndex(scene, options)) {
    for (const auto& [name, value] : indexConstants(scene.index)) program.set(name, value);
  }
}

}  // namespace twintrace
