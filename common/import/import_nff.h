#pragma once

#include "common/import/imported_scene.h"
#include "common/nff/nff_file.h"

namespace twintrace {

/// @throws as importScene
ImportedScene importNff(const std::string& path);

/// The scene that an NFF file describes.
ImportedScene sceneOfNff(const NffFile& file, const std::string& path);

/// The angle between the outer edges of the outermost pixels, in degrees, where `angle` is the one
/// between their centres: 2 atan(tan(angle / 2) n / (n - 1)).
/// @param pixels at least 2
double fovOfNff(double angleDegrees, int pixels);

}  // namespace twintrace
