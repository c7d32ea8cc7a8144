#pragma once

#include "common/hulls/hull_structure.h"
#include "common/hulls/volumes/kdop.h"

namespace twintrace {

HullVolume aabbVolume();
HullVolume sphereVolume();
HullVolume obbVolume();

}  // namespace twintrace
