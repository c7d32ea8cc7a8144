#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/hulls/convex_shape.h"

namespace twintrace {

/// How primitives are grouped, without hulls: each node is a range of `order`; its children lie side by
/// side and divide it. Node 0 is the root.
struct Topology {
  struct Node {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t firstChild = 0;
    std::uint32_t childCount = 0;  ///< 0 for a leaf
  };

  std::vector<Node> nodes;
  std::vector<std::uint32_t> order;  ///< primitives
  int depth = 0;                     ///< of the deepest leaf; 0 for a root alone
};

/// Nodes are no deeper than this, whatever the scene: what remains is halved.
inline constexpr int kMostDepth = 60;

/// Binary tree by the surface area heuristic over 16 bins an axis, in parallel. Wald 2007, "On fast
/// Construction of SAH-based Bounding Volume Hierarchies".
/// @param primitives what to group, with the bounds of each
Topology sahTopology(std::span<const std::uint32_t> primitives, std::span<const Bounds> bounds);

/// Median cut: halves by the centers, along x, y and z in turn, down to single primitives. Kay and
/// Kajiya 1986.
Topology medianTopology(std::span<const std::uint32_t> primitives, std::span<const Bounds> bounds);

/// Groups by the octants of cubes, by the centers, down to 8 primitives or 2^-20 of the whole.
Topology octreeTopology(std::span<const std::uint32_t> primitives, std::span<const Bounds> bounds);

/// Expected cost of a random line relative to one primitive test, with hull and primitive tests alike:
/// (sum of inner areas * children + sum of leaf areas * primitives) / root area. Goldsmith and Salmon 1987.
double sahCost(const Topology& topology, std::span<const Bounds> bounds);

}  // namespace twintrace
