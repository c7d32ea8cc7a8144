#pragma once

#include <vector>

#include "common/mesh/mesh.h"
#include "common/scene/shapes.h"

namespace twintrace {

/// What one object consists of, besides its material.
struct Parts {
  std::vector<SphereShape> spheres;
  std::vector<BoxShape> boxes;
  Mesh mesh;
};

}  // namespace twintrace
