#include "common/hulls/topology.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace twintrace {
namespace {

constexpr std::uint32_t kMostInOctant = 8;
constexpr int kMostOctants = 20;  // levels of the octree: an octant of 2^-20 of the whole is a point

/// Grows a tree over an order of primitives.
class Grower {
 public:
  Grower(std::span<const std::uint32_t> primitives, std::span<const Bounds> bounds)
      : bounds_(bounds) {
    tree_.order.assign(primitives.begin(), primitives.end());
    tree_.nodes.push_back({0, static_cast<std::uint32_t>(primitives.size()), 0, 0});
  }

  Topology take() { return std::move(tree_); }

 protected:
  glm::vec3 centerOf(std::uint32_t primitive) const { return bounds_[primitive].center(); }

  auto rangeOf(const Topology::Node& node) {
    return std::span(tree_.order).subspan(node.begin, node.end - node.begin);
  }

  /// Gives a node the children whose ranges end at these places. @return the first child
  std::size_t addChildren(std::size_t at, std::span<const std::uint32_t> ends) {
    const std::size_t first = tree_.nodes.size();
    std::uint32_t begin = tree_.nodes[at].begin;
    for (const std::uint32_t end : ends) {
      tree_.nodes.push_back({begin, end, 0, 0});
      begin = end;
    }
    tree_.nodes[at].firstChild = static_cast<std::uint32_t>(first);
    tree_.nodes[at].childCount = static_cast<std::uint32_t>(ends.size());
    return first;
  }

  void reached(int depth) { tree_.depth = std::max(tree_.depth, depth); }

  Topology tree_;

 private:
  std::span<const Bounds> bounds_;
};

class MedianGrower : public Grower {
 public:
  using Grower::Grower;

  void divide(std::size_t at, int depth) {
    reached(depth);
    const Topology::Node node = tree_.nodes[at];
    if (node.end - node.begin <= 1) return;
    const int axis = depth % 3;
    const std::uint32_t middle = node.begin + (node.end - node.begin) / 2;
    const auto begin = tree_.order.begin();
    std::nth_element(begin + node.begin, begin + middle, begin + node.end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const float atA = centerOf(a)[axis];
                       const float atB = centerOf(b)[axis];
                       return atA < atB || (atA == atB && a < b);
                     });
    const std::array<std::uint32_t, 2> ends = {middle, node.end};
    const std::size_t first = addChildren(at, ends);
    divide(first, depth + 1);
    divide(first + 1, depth + 1);
  }
};

class OctreeGrower : public Grower {
 public:
  using Grower::Grower;

  void grow() {
    Bounds all = Bounds::nothing();
    for (const std::uint32_t primitive : tree_.order) all.add(centerOf(primitive));
    const glm::vec3 size = all.high - all.low;
    divide(0, all.center(), 0.5f * std::max({size.x, size.y, size.z}), 0);
  }

 private:
  static int octantOf(const glm::vec3& p, const glm::vec3& middle) {
    return (p.x >= middle.x ? 1 : 0) + (p.y >= middle.y ? 2 : 0) + (p.z >= middle.z ? 4 : 0);
  }

  void divide(std::size_t at, const glm::vec3& middle, float half, int depth) {
    reached(depth);
    const Topology::Node node = tree_.nodes[at];
    if (node.end - node.begin <= kMostInOctant || depth >= kMostOctants) return;
    const auto octant = [&](std::uint32_t primitive) { return octantOf(centerOf(primitive), middle); };
    std::ranges::stable_sort(rangeOf(node), {}, octant);
    std::vector<std::uint32_t> ends;
    std::vector<int> octants;
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const int here = octant(tree_.order[i]);
      if (octants.empty() || octants.back() != here) {
        octants.push_back(here);
        ends.push_back(i);
      }
      ends.back() = i + 1;
    }
    const std::size_t first = addChildren(at, ends);
    for (std::size_t i = 0; i < octants.size(); ++i) {
      const float quarter = half * 0.5f;
      const glm::vec3 side((octants[i] & 1) != 0 ? quarter : -quarter,
                           (octants[i] & 2) != 0 ? quarter : -quarter,
                           (octants[i] & 4) != 0 ? quarter : -quarter);
      divide(first + i, middle + side, quarter, depth + 1);
    }
  }
};

}  // namespace

Topology medianTopology(std::span<const std::uint32_t> primitives,
                        std::span<const Bounds> bounds) {
  MedianGrower grower(primitives, bounds);
  grower.divide(0, 0);
  return grower.take();
}

Topology octreeTopology(std::span<const std::uint32_t> primitives,
                        std::span<const Bounds> bounds) {
  OctreeGrower grower(primitives, bounds);
  if (!primitives.empty()) grower.grow();
  return grower.take();
}

double sahCost(const Topology& topology, std::span<const Bounds> bounds) {
  std::vector<Bounds> hulls(topology.nodes.size(), Bounds::nothing());
  double sum = 0.0;
  // Children come after their parents.
  for (std::size_t at = topology.nodes.size(); at-- > 0;) {
    const Topology::Node& node = topology.nodes[at];
    for (std::uint32_t i = 0; i < node.childCount; ++i) hulls[at].add(hulls[node.firstChild + i]);
    if (node.childCount == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        hulls[at].add(bounds[topology.order[i]]);
      }
    }
    const std::uint32_t tests = node.childCount == 0 ? node.end - node.begin : node.childCount;
    sum += double(hulls[at].halfArea()) * tests;
  }
  const double whole = hulls[0].halfArea();
  return whole > 0.0 ? sum / whole : 0.0;
}

}  // namespace twintrace
