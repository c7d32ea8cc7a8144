#pragma once

#include <optional>

#include "common/scene/flat_scene.h"
#include "gpu/buffers.h"
#include "gpu/program.h"

namespace twintrace {

/// Sets what the shaders' scene access reads besides the texels.
void setSceneUniforms(Program& program, const FlatScene& scene, const RenderOptions& options);

/// A scene's texels, and those of its hulls, on the device.
class SceneTextures {
 public:
  /// @throws DeviceError with the figures if there are more than the device allows.
  SceneTextures(Context& context, const FlatScene& scene);

  /// Puts them where the shaders' scene access reads them.
  void bind() const;

 private:
  BufferTexture texels_;
  std::optional<BufferTexture> hulls_;
};

}  // namespace twintrace
