#pragma once

#include <vector>

#include "common/scene/file_check.h"
#include "common/scene/scene.h"
#include "common/scene/toml_table.h"

namespace twintrace {

/// [materials.NAME], in the order of their names.
void readMaterials(TableReader& document, std::vector<Material>& materials);

/// [[objects]]; needs the scene's materials. An object without a name is called SHAPE-INDEX.
/// @param check asked for each mesh file
void readObjects(TableReader& document, const FileCheck& check, Scene& scene);

/// [[lights]], at most kMaxLights.
void readLights(TableReader& document, std::vector<Light>& lights);

}  // namespace twintrace
