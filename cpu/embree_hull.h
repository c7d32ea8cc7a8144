#pragma once

#include <memory>

#include "common/scene/flat_scene.h"
#include "cpu/hull_query.h"

namespace twintrace {

/// Embree's tree over this scene's spheres and boxes with the kernel's own primitive tests in its
/// leaves, planes tested outside: bit for bit the hits of testing every primitive, for every ray.
/// Rays that the tree's padding is not made for (see embree_hull.cpp) do test every primitive.
/// As in all kernel code, FTZ and DAZ must be set on the calling thread for the bits of the
/// shaders.
/// @param scene must outlive the query
/// @throws UsageError for precision double: Embree's rays are floats.
/// @throws DeviceError if Embree fails.
std::unique_ptr<HullQuery> makeEmbreeHull(const FlatScene& scene, const RenderOptions& options);

}  // namespace twintrace
