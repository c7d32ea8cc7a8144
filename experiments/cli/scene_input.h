#pragma once

#include <string>

#include "common/scene/reader.h"
#include "experiments/cli/console.h"

namespace twintrace {

/// Reads a scene file and says what is odd but harmless in the files that it names.
/// @throws what readScene throws
Scene openScene(const Console& console, const std::string& path);

}  // namespace twintrace
