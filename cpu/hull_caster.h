#pragma once

#include <memory>

#include "common/hulls/hull_caster.h"
#include "common/scene/flat_scene.h"

namespace twintrace {

/// Casts with the C++ tracer's hulls, in the precision, maths, intersector and threads of the options;
/// a scene without hulls tests every primitive.
/// @throws UsageError for hull embree in precision double, DeviceError if Embree fails.
std::unique_ptr<HullCaster> makeCpuHullCaster(std::shared_ptr<const FlatScene> scene,
                                              const RenderOptions& options);

}  // namespace twintrace
