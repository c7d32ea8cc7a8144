#pragma once

#include "common/hulls/hull_structure.h"

namespace twintrace {

/// How much larger the outermost hulls are than the convex hulls of what they contain; 1 is as tight as
/// any convex hull can be. By Crofton's formula a random line that meets a hull misses its contents with
/// probability 1 - 1 / area, if those are convex.
struct Tightness {
  double area = 0.0;    ///< ratio of the surface areas, summed over the outermost hulls
  double volume = 0.0;  ///< ratio of the volumes
};

/// Tightness of a structure's outermost hulls: each object's own, or a tree's root. The convex hulls are
/// taken with 512 pairs of slabs, up to 1 % too large for round objects; those of single primitives are
/// exact. Of more than 64 outermost hulls evenly spaced ones are measured.
Tightness tightnessOf(const FlatScene& scene, const HullStructure& hulls);

}  // namespace twintrace
