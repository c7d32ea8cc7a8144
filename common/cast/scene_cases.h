#pragma once

#include <span>

#include "common/cast/case_set.h"
#include "common/scene/flat_scene.h"

namespace twintrace {

/// The rays against one case scene that holds all primitives of the flat scene, whatever its effects
/// leave out, in its order and under the names of their objects.
CaseSet casesOf(const FlatScene& scene, std::span<const CastRay> rays);

}  // namespace twintrace
