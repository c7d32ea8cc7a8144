#include "cpu/bvh8_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "common/hulls/convex_shape.h"

namespace twintrace {
namespace {

/// Subtrees of no more primitives become leaves: a block costs about as much as a node.
constexpr std::uint32_t kMostInLeaf = 8;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class Widener {
 public:
  Widener(const FlatScene& scene, const HullStructure& hulls) : scene_(scene), hulls_(hulls) {
    countPrimitives(0);
  }

  Bvh8Tree run() {
    tree_.nodes.emplace_back();
    fill(0, isLeaf(0) ? std::vector<int>{0} : childrenOf(0));
    return std::move(tree_);
  }

 private:
  std::uint32_t countPrimitives(int node) {
    counts_.resize(static_cast<std::size_t>(hulls_.nodeCount));
    const HullLink link = hulls_.link(node);
    std::uint32_t count = link.inner ? 0 : link.count;
    for (std::uint32_t i = 0; link.inner && i < link.count; ++i) {
      count += countPrimitives(static_cast<int>(link.first + i));
    }
    counts_[static_cast<std::size_t>(node)] = count;
    return count;
  }

  bool isLeaf(int node) const {
    return !hulls_.link(node).inner || counts_[static_cast<std::size_t>(node)] <= kMostInLeaf;
  }

  std::vector<int> childrenOf(int node) const {
    const HullLink link = hulls_.link(node);
    std::vector<int> children;
    for (std::uint32_t i = 0; i < link.count; ++i) {
      children.push_back(static_cast<int>(link.first + i));
    }
    return children;
  }

  double area(int node) const { return hulls_.volume.area(hulls_.volume, hulls_.record(node)); }

  /// Puts the children of the largest inner child in its place, while there is room.
  std::vector<int> widened(std::vector<int> children) const {
    while (true) {
      auto largest = children.end();
      for (auto it = children.begin(); it != children.end(); ++it) {
        const bool fits = children.size() + hulls_.link(*it).count - 1 <= kBvh8Width;
        if (isLeaf(*it) || !fits) continue;
        if (largest == children.end() || area(*it) > area(*largest)) largest = it;
      }
      if (largest == children.end()) return children;
      const std::vector<int> below = childrenOf(*largest);
      children.erase(largest);
      children.insert(children.end(), below.begin(), below.end());
    }
  }

  void fill(std::size_t at, std::vector<int> children) {
    children = widened(std::move(children));
    Bvh8Node node{};
    for (int i = 0; i < kBvh8Width; ++i) {
      setBounds(node, i, i < static_cast<int>(children.size()) ? children[static_cast<std::size_t>(i)] : -1);
    }
    for (std::uint32_t& child : node.child) child = Bvh8Child::leaf(0, 0);
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (isLeaf(children[i])) {
        node.child[i] = addLeaf(children[i]);
        continue;
      }
      node.child[i] = static_cast<std::uint32_t>(tree_.nodes.size());
      tree_.nodes.emplace_back();
      fill(node.child[i], childrenOf(children[i]));
    }
    for (unsigned octant = 0; octant < 8; ++octant) node.order[octant] = orderOf(node, octant);
    tree_.nodes[at] = node;
  }

  /// By the centers' heights along the octant's diagonal; missing children come last.
  static std::uint32_t orderOf(const Bvh8Node& node, unsigned octant) {
    std::array<std::uint32_t, kBvh8Width> children;
    std::iota(children.begin(), children.end(), 0u);
    const auto height = [&](std::uint32_t child) {
      float sum = 0.0f;
      for (int axis = 0; axis < 3; ++axis) {
        const float center = node.bounds[2 * axis][child] + node.bounds[2 * axis + 1][child];
        sum += (octant >> axis & 1u) != 0 ? -center : center;
      }
      return node.bounds[0][child] > node.bounds[1][child] ? -kInfinity : sum;
    };
    std::ranges::stable_sort(children, std::ranges::greater{}, height);
    std::uint32_t order = 0;
    for (std::uint32_t i = 0; i < kBvh8Width; ++i) order |= children[i] << (4 * i);
    return order;
  }

  void setBounds(Bvh8Node& node, int i, int child) const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto bound = [&](std::size_t texel) {
        return std::bit_cast<float>(hulls_.record(child)[texel][axis]);
      };
      node.bounds[2 * axis][i] = child < 0 ? kInfinity : bound(0);
      node.bounds[2 * axis + 1][i] = child < 0 ? -kInfinity : bound(1);
    }
  }

  std::uint32_t addLeaf(int node) {
    std::vector<std::uint32_t> primitives = hulls_.primitivesBelow(node);
    std::ranges::sort(primitives);  // kinds are ranges of numbers
    const auto first = static_cast<std::uint32_t>(tree_.blocks.size());
    for (const std::uint32_t primitive : primitives) add(primitive, first);
    const std::uint32_t count = static_cast<std::uint32_t>(tree_.blocks.size()) - first;
    if (count > Bvh8Child::kMostBlocks || first > Bvh8Child::kFirstMask) {
      throw std::length_error("a leaf of bvh8 with too many primitives");
    }
    return Bvh8Child::leaf(first, count);
  }

  void add(std::uint32_t primitive, std::uint32_t firstBlock) {
    const Bvh8Kind kind = kindOf(primitive);
    const bool opens = tree_.blocks.size() == firstBlock || tree_.blocks.back().kind != kind ||
                       tree_.blocks.back().count == kBvh8Width;
    if (opens) tree_.blocks.push_back(Bvh8Block{{}, {}, kind, 0});
    Bvh8Block& block = tree_.blocks.back();
    const std::uint32_t lane = block.count++;
    block.primitives[lane] = primitive;
    const ConvexShape shape = convexShape(scene_, static_cast<int>(primitive));
    if (kind == Bvh8Kind::other) return;
    for (int i = 0; i < shape.count; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        block.values[3 * i + axis][lane] =
            static_cast<float>(shape.points[static_cast<std::size_t>(i)][axis]);
      }
    }
    if (kind == Bvh8Kind::sphere) block.values[3][lane] = static_cast<float>(shape.radius);
  }

  Bvh8Kind kindOf(std::uint32_t primitive) const {
    const SceneIndex& index = scene_.index;
    const auto number = static_cast<int>(primitive);
    if (number < index.sphereCount) return Bvh8Kind::sphere;
    return number < index.boundedCount() - index.triangleCount ? Bvh8Kind::other : Bvh8Kind::triangle;
  }

  const FlatScene& scene_;
  const HullStructure& hulls_;
  std::vector<std::uint32_t> counts_;
  Bvh8Tree tree_;
};

}  // namespace

Bvh8Tree widen(const FlatScene& scene, const HullStructure& hulls) {
  return Widener(scene, hulls).run();
}

}  // namespace twintrace
