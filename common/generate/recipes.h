#pragma once

#include "common/generate/generators.h"

// The generators that the table in generators.cpp lists: how many primitives, and which. Only integer
// arithmetic, + - * / and square roots, so that every platform makes the same scene.

namespace twintrace {

/// Spheres on spheres, nine on each, after Haines 1987 ("A Proposal for Standard Graphics
/// Environments", `balls`).
std::int64_t sphereflakeCount(int levels);
std::vector<Parts> makeSphereflake(int levels, std::uint32_t seed);

/// Sierpinski's tetrahedron of 4^size triangles, after Haines 1987 (`tetra`).
std::int64_t tetraCount(int levels);
std::vector<Parts> makeTetra(int levels, std::uint32_t seed);

/// A fractal mountain of 2 4^size triangles by midpoint displacement. Fournier, Fussell and Carpenter
/// 1982, "Computer Rendering of Stochastic Models".
std::int64_t mountCount(int levels);
std::vector<Parts> makeMount(int levels, std::uint32_t seed);

/// A tree of tapered branches, each of 16 triangles with a sphere at its end, that forks `levels`
/// times.
std::int64_t treeCount(int levels);
std::vector<Parts> makeTree(int levels, std::uint32_t seed);

/// `count` spheres or boxes (every second one turned) at random, about as dense whatever their number.
std::vector<Parts> makeSpheres(int count, std::uint32_t seed);
std::vector<Parts> makeBoxes(int count, std::uint32_t seed);

/// Ten lumpy balls in a row, ten objects of 8 4^size triangles each.
std::int64_t rowCount(int levels);
std::vector<Parts> makeRow(int levels, std::uint32_t seed);

}  // namespace twintrace
