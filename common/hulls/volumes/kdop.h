#pragma once

#include "common/hulls/hull_structure.h"

namespace twintrace {

/// Normals in the order of slabCoordinates (shaders/hulls/hull_ray.glsl): 3 axes, 4 diagonals of the
/// cube, 6 diagonals of its faces.
inline constexpr int kMostSlabs = 13;

// Sets of normals.
inline constexpr std::uint32_t kAxes = 0x0007;
inline constexpr std::uint32_t kCubeDiagonals = 0x0078;
inline constexpr std::uint32_t kFaceDiagonals = 0x1f80;

/// Whether the volume's hulls use a slab.
bool usesSlab(const HullVolume& volume, int slab);

/// @param slabs a bit for each normal used
HullVolume kdopVolume(std::uint32_t slabs);

}  // namespace twintrace
