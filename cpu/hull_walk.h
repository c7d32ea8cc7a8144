#pragma once

#include <memory>

#include "common/scene/flat_scene.h"
#include "cpu/hull_query.h"

namespace twintrace {

/// Walks through the scene's own hulls, or without any through all primitives, with the kernel's maths and
/// intersector of these options. As in all kernel code, FTZ and DAZ must be set on the calling thread for
/// the bits of the shaders.
/// @param scene must outlive the query
std::unique_ptr<HullQuery> makeHullWalk(const FlatScene& scene, const RenderOptions& options);

/// What answers the scene's closest-hit queries under these options: Embree's tree, the scene's own
/// hulls, or null where every primitive is tested.
/// @throws UsageError for hull embree in precision double, DeviceError if Embree fails.
std::unique_ptr<HullQuery> makeHullQuery(const FlatScene& scene, const RenderOptions& options);

// Nodes of eight boxes: see bvh8_tree.h.
std::unique_ptr<HullQuery> makeBvh8Sse2(const FlatScene& scene, const RenderOptions& options);
std::unique_ptr<HullQuery> makeBvh8Avx2(const FlatScene& scene, const RenderOptions& options);

// makeHullWalk as compiled for two instruction sets; null for a volume without a test.
std::unique_ptr<HullQuery> makeHullWalkBaseline(const FlatScene& scene, const RenderOptions& options);
std::unique_ptr<HullQuery> makeHullWalkAvx2(const FlatScene& scene, const RenderOptions& options);

}  // namespace twintrace
