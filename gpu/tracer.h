#pragma once

#include <memory>

#include "common/scene/flat_scene.h"
#include "common/trace/renderer.h"

namespace twintrace {

/// The GLSL tracer of one scene, as a fragment or a compute shader.
/// @throws DeviceError if there is no such provider, or the program or the film doesn't fit the
/// device; UsageError if the options exclude each other.
std::unique_ptr<Renderer> makeGpuRenderer(std::shared_ptr<const FlatScene> scene,
                                          const RenderOptions& options);

}  // namespace twintrace
