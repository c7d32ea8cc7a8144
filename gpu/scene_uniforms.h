#pragma once

#include "common/scene/flat_scene.h"
#include "gpu/program.h"

namespace twintrace {

/// Sets what the shaders' scene access reads besides the texels; those are on texture unit 0.
void setSceneUniforms(Program& program, const FlatScene& scene, const RenderOptions& options);

}  // namespace twintrace
