#include <tbb/blocked_range.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <limits>

#include "common/base/parallel_for.h"
#include "common/hulls/topology.h"

namespace twintrace {
namespace {

constexpr int kBins = 16;
constexpr std::uint32_t kSmallestTask = 2048;  // primitives; below, a task costs more than it saves
constexpr float kNodeCost = 1.0f;              // of visiting a node, in primitive tests
constexpr std::uint32_t kMostInLeaf = 8;

struct Reference {
  Bounds bounds;
  std::uint32_t primitive;

  float centerTwice(int axis) const { return bounds.low[axis] + bounds.high[axis]; }
};

struct Bin {
  Bounds bounds = Bounds::nothing();
  std::uint32_t count = 0;

  void add(const Bin& other) {
    bounds.add(other.bounds);
    count += other.count;
  }
  float cost() const { return count == 0 ? 0.0f : bounds.halfArea() * static_cast<float>(count); }
};

struct Split {
  int axis = -1;  ///< -1: none
  int bin = 0;    ///< first bin of the right side
  float cost = 0;
  std::uint32_t larger = 0;  ///< primitives on the fuller side

  /// Of equal costs, which points and lines have, the more even one keeps the tree flat.
  bool isBetterThan(const Split& other) const {
    if (other.axis < 0 || cost < other.cost) return true;
    return cost == other.cost && larger < other.larger;
  }
};

/// Which bin of an axis a reference falls into.
class Binning {
 public:
  Binning(const Bounds& centersTwice, int axis) : axis_(axis), low_(centersTwice.low[axis]) {
    const float size = centersTwice.high[axis] - low_;
    scale_ = size > 0.0f ? float(kBins) / size : 0.0f;
  }

  bool divides() const { return scale_ > 0.0f && scale_ < std::numeric_limits<float>::infinity(); }
  int binOf(const Reference& reference) const {
    const float place = (reference.centerTwice(axis_) - low_) * scale_;
    return std::clamp(static_cast<int>(place), 0, kBins - 1);
  }

 private:
  int axis_;
  float low_;
  float scale_ = 0.0f;
};

class SahBuilder {
 public:
  SahBuilder(std::span<const std::uint32_t> primitives, std::span<const Bounds> bounds)
      : references_(primitives.size()), nodes_(std::max<std::size_t>(2 * primitives.size(), 1)) {
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      references_[i] = {bounds[primitives[i]], primitives[i]};
    }
  }

  Topology run() {
    nodes_[0] = {0, static_cast<std::uint32_t>(references_.size()), 0, 0};
    divide(0, 0);
    return numbered();
  }

 private:
  void divide(std::uint32_t at, int depth) {
    Topology::Node& node = nodes_[at];
    const std::uint32_t middle = middleOf(node, depth);
    if (middle == node.begin) return;
    const std::uint32_t children = used_.fetch_add(2);
    nodes_[children] = {node.begin, middle, 0, 0};
    nodes_[children + 1] = {middle, node.end, 0, 0};
    node.firstChild = children;
    node.childCount = 2;
    const tbb::blocked_range<std::uint32_t> both(children, children + 2);
    const auto divideAll = [&](const tbb::blocked_range<std::uint32_t>& some) {
      for (std::uint32_t child = some.begin(); child < some.end(); ++child) divide(child, depth + 1);
    };
    if (node.end - node.begin >= kSmallestTask) {
      parallelFor(both, divideAll, tbb::simple_partitioner());
    } else {
      divideAll(both);
    }
  }

  /// Where the node's references, brought in order, part; the begin for a leaf.
  std::uint32_t middleOf(const Topology::Node& node, int depth) {
    const std::uint32_t count = node.end - node.begin;
    if (count <= 1) return node.begin;
    if (depth + std::bit_width(count) >= kMostDepth) return node.begin + count / 2;
    Bounds all = Bounds::nothing();
    Bounds centers = Bounds::nothing();
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      all.add(references_[i].bounds);
      centers.add(references_[i].bounds.low + references_[i].bounds.high);
    }
    const Split split = bestSplit(node, centers);
    const float leafCost = all.halfArea() * static_cast<float>(count);
    const bool pays = split.axis >= 0 && split.cost + all.halfArea() * kNodeCost < leafCost;
    if (!pays && count <= kMostInLeaf) return node.begin;
    if (split.axis < 0) return node.begin + count / 2;
    const Binning binning(centers, split.axis);
    const auto begin = references_.begin();
    const auto middle =
        std::partition(begin + node.begin, begin + node.end,
                       [&](const Reference& r) { return binning.binOf(r) < split.bin; });
    return static_cast<std::uint32_t>(middle - begin);
  }

  Split bestSplit(const Topology::Node& node, const Bounds& centers) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      const Binning binning(centers, axis);
      if (!binning.divides()) continue;
      std::array<Bin, kBins> bins;
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        Bin& bin = bins[static_cast<std::size_t>(binning.binOf(references_[i]))];
        bin.bounds.add(references_[i].bounds);
        ++bin.count;
      }
      improve(bins, axis, best);
    }
    return best;
  }

  /// Takes the best place between the bins if it is better than the best so far.
  static void improve(const std::array<Bin, kBins>& bins, int axis, Split& best) {
    std::array<float, kBins> rightCost{};
    std::array<std::uint32_t, kBins> rightCount{};
    Bin right;
    for (int i = kBins - 1; i > 0; --i) {
      right.add(bins[static_cast<std::size_t>(i)]);
      rightCost[static_cast<std::size_t>(i)] = right.cost();
      rightCount[static_cast<std::size_t>(i)] = right.count;
    }
    Bin left;
    for (int i = 1; i < kBins; ++i) {
      left.add(bins[static_cast<std::size_t>(i - 1)]);
      if (left.count == 0 || rightCount[static_cast<std::size_t>(i)] == 0) continue;
      const Split split = {axis, i, left.cost() + rightCost[static_cast<std::size_t>(i)],
                           std::max(left.count, rightCount[static_cast<std::size_t>(i)])};
      if (split.isBetterThan(best)) best = split;
    }
  }

  /// The tree with its nodes numbered depth first: tasks take numbers as they come.
  Topology numbered() const {
    Topology result;
    result.order.reserve(references_.size());
    for (const Reference& reference : references_) result.order.push_back(reference.primitive);
    result.nodes.reserve(used_);
    result.nodes.push_back(nodes_[0]);
    copyChildren(result, 0, 0);
    return result;
  }

  void copyChildren(Topology& result, std::size_t at, int depth) const {
    result.depth = std::max(result.depth, depth);
    const Topology::Node node = result.nodes[at];
    if (node.childCount == 0) return;
    const std::size_t children = result.nodes.size();
    result.nodes[at].firstChild = static_cast<std::uint32_t>(children);
    for (std::uint32_t i = 0; i < node.childCount; ++i) {
      result.nodes.push_back(nodes_[node.firstChild + i]);
    }
    for (std::uint32_t i = 0; i < node.childCount; ++i) {
      copyChildren(result, children + i, depth + 1);
    }
  }

  std::vector<Reference> references_;
  std::vector<Topology::Node> nodes_;
  std::atomic<std::uint32_t> used_ = 1;
};

}  // namespace

Topology sahTopology(std::span<const std::uint32_t> primitives, std::span<const Bounds> bounds) {
  return SahBuilder(primitives, bounds).run();
}

}  // namespace twintrace
