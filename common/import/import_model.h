#pragma once

#include "common/import/imported_scene.h"

namespace twintrace {

/// Reads an OBJ, PLY or glTF file; one object for each material that triangles have. Where it has
/// no camera, one looks at all of it; where it has no light, there is a sun and a grey environment.
/// @throws as importScene
ImportedScene importModel(const std::string& path);

}  // namespace twintrace
