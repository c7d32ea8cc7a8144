#pragma once

#include <memory>

#include "common/scene/flat_scene.h"
#include "common/trace/ray_caster.h"

namespace twintrace {

/// The CPU kernel as a ray caster, over all threads: `cpu` in float, `cpu64` in double, whose t and
/// normals are rounded to float at the end. Normals are outward and unit, a plane's as authored.
/// Reads maths, precision, intersector, hull and threads of the options.
/// Denormal inputs are read as zero. A ray that is not a number somewhere, that has an infinite
/// origin or direction or a direction of zeros misses; so does a hit beyond the largest float.
/// @throws UsageError if the options exclude each other, DeviceError if Embree fails.
std::unique_ptr<RayCaster> makeKernelCaster(std::shared_ptr<const FlatScene> scene,
                                            const RenderOptions& options);

}  // namespace twintrace
