#pragma once

#include <cstdint>
#include <vector>

#include "common/hulls/hull_structure.h"

namespace twintrace {

inline constexpr int kBvh8Width = 8;

/// Eight boxes side by side, and what lies in each. `bounds` has the least and the greatest coordinate
/// along x, y and z; a child that is missing has empty bounds and is a leaf without blocks.
struct alignas(64) Bvh8Node {
  float bounds[6][kBvh8Width];
  std::uint32_t child[kBvh8Width];  ///< a node, or a leaf: see Bvh8Child
  /// For each octant of directions the children from the last to the first that such a ray meets, four
  /// bits each; octants have a bit for each axis along which a ray goes back. An approximation: it costs
  /// time where it is wrong, never a hit.
  std::uint32_t order[8];
};

/// A leaf is a range of blocks, in one word with a mark.
struct Bvh8Child {
  static constexpr std::uint32_t kLeaf = 1u << 31;
  static constexpr int kCountShift = 28;
  static constexpr std::uint32_t kMostBlocks = 7;
  static constexpr std::uint32_t kFirstMask = (1u << kCountShift) - 1;

  static std::uint32_t leaf(std::uint32_t first, std::uint32_t count) {
    return kLeaf | count << kCountShift | first;
  }
  static bool isLeaf(std::uint32_t child) { return (child & kLeaf) != 0; }
  static std::uint32_t first(std::uint32_t child) { return child & kFirstMask; }
  static std::uint32_t count(std::uint32_t child) {
    return (child & ~kLeaf) >> kCountShift;
  }
};

enum class Bvh8Kind : std::uint32_t { sphere, triangle, other };

/// Up to eight primitives of one kind side by side, for a quick test: of spheres center and radius, of
/// triangles the three corners, each x, y and z; of other kinds nothing.
struct alignas(64) Bvh8Block {
  float values[9][kBvh8Width];
  std::uint32_t primitives[kBvh8Width];
  Bvh8Kind kind;
  std::uint32_t count;
};

/// A tree of wide nodes; node 0 is the root. Wald, Benthin and Boulos 2008, "Getting Rid of Packets".
struct Bvh8Tree {
  std::vector<Bvh8Node> nodes;
  std::vector<Bvh8Block> blocks;
};

/// Widens a binary tree of boxes: each node takes in the largest of its inner children until it has eight.
/// @param hulls a tree of volume aabb
Bvh8Tree widen(const FlatScene& scene, const HullStructure& hulls);

}  // namespace twintrace
