#pragma once

#include "common/scene/scene.h"

namespace twintrace {

/// Reads the scene's meshes and makes what its generators make. A generator of several objects becomes
/// as many, named NAME-0, NAME-1, ... What a mesh has that is odd but harmless goes to the warnings.
/// @throws FileError with all meshes that are no use.
void expandShapes(Scene& scene);

}  // namespace twintrace
