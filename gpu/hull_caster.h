#pragma once

#include <memory>

#include "common/hulls/hull_caster.h"
#include "common/scene/flat_scene.h"

namespace twintrace {

/// Casts with the shaders' hulls on the provider and stage of the options; a scene without hulls tests
/// every primitive.
/// @throws UsageError for options that the GPU does not have or scenes of more than 2^24 primitives,
/// DeviceError if the device fails.
std::unique_ptr<HullCaster> makeGpuHullCaster(std::shared_ptr<const FlatScene> scene,
                                              const RenderOptions& options);

}  // namespace twintrace
