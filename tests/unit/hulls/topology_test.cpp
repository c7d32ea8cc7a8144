#include "common/hulls/topology.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/catch.h"
#include "tests/unit/hulls/convex_fixtures.h"

namespace twintrace {
namespace {

using test::firstPrimitives;
using Build = Topology (*)(std::span<const std::uint32_t>, std::span<const Bounds>);

struct Method {
  std::string name;
  Build build;
};

const std::vector<Method> kMethods = {
    {"sah", sahTopology}, {"median", medianTopology}, {"octree", octreeTopology}};

Bounds boxAt(const glm::vec3& center, float halfSize) {
  return {center - halfSize, center + halfSize};
}

std::vector<Bounds> randomBoxes(int count, std::uint64_t seed) {
  CaseRandom random(seed);
  std::vector<Bounds> boxes;
  for (int i = 0; i < count; ++i) {
    boxes.push_back(boxAt(glm::vec3(random.inCube(10.0)), float(random.uniform(0.0, 0.5))));
  }
  return boxes;
}

/// What is wrong with a node's children; empty if they lie side by side and divide its range.
std::string faultOfChildren(const Topology& tree, const Topology::Node& node, std::size_t at) {
  if (node.firstChild <= at) return "a child before its parent";
  if (node.firstChild + node.childCount > tree.nodes.size()) return "a child that is not there";
  std::uint32_t begin = node.begin;
  for (std::uint32_t i = 0; i < node.childCount; ++i) {
    const Topology::Node& child = tree.nodes[node.firstChild + i];
    if (child.begin != begin) return "a gap between children";
    if (child.end <= child.begin) return "an empty child";
    begin = child.end;
  }
  return begin == node.end ? "" : "children that do not fill their parent";
}

/// Checks that a tree is one over these primitives, and its depth. @return the depth
int checkTree(const Topology& tree, std::vector<std::uint32_t> primitives) {
  std::vector<std::uint32_t> order = tree.order;
  std::ranges::sort(order);
  std::ranges::sort(primitives);
  CHECK(order == primitives);
  REQUIRE_FALSE(tree.nodes.empty());
  CHECK(tree.nodes[0].begin == 0);
  CHECK(tree.nodes[0].end == primitives.size());
  std::vector<int> depths(tree.nodes.size(), -1);
  depths[0] = 0;
  for (std::size_t at = 0; at < tree.nodes.size(); ++at) {
    const Topology::Node& node = tree.nodes[at];
    REQUIRE(depths[at] >= 0);
    if (node.childCount == 0) continue;
    REQUIRE(faultOfChildren(tree, node, at).empty());
    for (std::uint32_t i = 0; i < node.childCount; ++i) {
      REQUIRE(depths[node.firstChild + i] == -1);
      depths[node.firstChild + i] = depths[at] + 1;
    }
  }
  const int deepest = *std::ranges::max_element(depths);
  CHECK(tree.depth == deepest);
  CHECK(tree.depth <= kMostDepth);
  return deepest;
}

/// Tiny boxes that come nearer to the origin by a factor each, along every axis: no bin parts more
/// than one of an axis from the rest.
std::vector<Bounds> progressions(double factor) {
  std::vector<Bounds> boxes;
  for (int axis = 0; axis < 3; ++axis) {
    for (double place = 1e18; place > 1e-35; place *= factor) {
      glm::vec3 center(0.0f);
      center[axis] = float(place);
      boxes.push_back(boxAt(center, 0.0f));
    }
  }
  return boxes;
}

TEST_CASE("Trees hold each primitive once, in ranges that children divide", "[hulls]") {
  for (const Method& method : kMethods) {
    for (const int count : {1, 2, 3, 8, 9, 100, 5000}) {
      INFO(method.name << " of " << count);
      checkTree(method.build(firstPrimitives(count), randomBoxes(count, 1)),
                firstPrimitives(count));
    }
  }
}

TEST_CASE("Trees group only the primitives that they are given", "[hulls]") {
  std::vector<std::uint32_t> every7th;
  for (std::uint32_t i = 3; i < 5000; i += 7) every7th.push_back(i);
  for (const Method& method : kMethods) {
    INFO(method.name);
    checkTree(method.build(every7th, randomBoxes(5000, 2)), every7th);
  }
}

TEST_CASE("Trees of nothing are an empty root", "[hulls]") {
  for (const Method& method : kMethods) {
    INFO(method.name);
    const Topology tree = method.build({}, {});
    REQUIRE(tree.nodes.size() == 1);
    CHECK(tree.nodes[0].childCount == 0);
    CHECK(tree.nodes[0].end == 0);
  }
}

TEST_CASE("Trees of 10000 equal boxes are no deeper than the limit", "[hulls]") {
  const std::vector<Bounds> boxes(10000, boxAt({1, 2, 3}, 0.5f));
  for (const Method& method : kMethods) {
    INFO(method.name);
    checkTree(method.build(firstPrimitives(10000), boxes), firstPrimitives(10000));
  }
  CHECK(sahTopology(firstPrimitives(10000), boxes).depth <= 14);
}

TEST_CASE("Trees of geometric progressions are no deeper than the limit", "[hulls]") {
  for (const double factor : {0.5, 0.1, 1.0 / 17.0}) {
    const std::vector<Bounds> boxes = progressions(factor);
    for (const Method& method : kMethods) {
      INFO(method.name << " by " << factor);
      checkTree(method.build(firstPrimitives(boxes.size()), boxes), firstPrimitives(boxes.size()));
    }
  }
}

TEST_CASE("Trees of nested boxes are no deeper than the limit", "[hulls]") {
  std::vector<Bounds> boxes;
  for (float size = 1e18f; size > 1e-30f; size *= 0.5f) {
    for (int i = 0; i < 20; ++i) boxes.push_back({glm::vec3(0.0f), glm::vec3(size)});
  }
  for (const Method& method : kMethods) {
    INFO(method.name);
    checkTree(method.build(firstPrimitives(boxes.size()), boxes), firstPrimitives(boxes.size()));
  }
}

TEST_CASE("Trees of what lies on a line or in a plane are no deeper than the limit", "[hulls]") {
  std::vector<Bounds> line, plane;
  for (int i = 0; i < 3000; ++i) {
    line.push_back(boxAt({float(i), 0, 0}, 0.25f));
    plane.push_back(boxAt({float(i % 60), 5, float(i / 60)}, 0.0f));
  }
  for (const Method& method : kMethods) {
    INFO(method.name);
    CHECK(checkTree(method.build(firstPrimitives(3000), line), firstPrimitives(3000)) <= 20);
    CHECK(checkTree(method.build(firstPrimitives(3000), plane), firstPrimitives(3000)) <= 20);
  }
}

TEST_CASE("sahTopology makes the same tree each time, though in parallel", "[hulls]") {
  const std::vector<Bounds> boxes = randomBoxes(50000, 3);
  const Topology a = sahTopology(firstPrimitives(boxes.size()), boxes);
  for (int run = 0; run < 3; ++run) {
    const Topology b = sahTopology(firstPrimitives(boxes.size()), boxes);
    CHECK(a.order == b.order);
    REQUIRE(a.nodes.size() == b.nodes.size());
    CHECK(std::ranges::equal(a.nodes, b.nodes, [](const auto& x, const auto& y) {
      return x.begin == y.begin && x.end == y.end && x.firstChild == y.firstChild &&
             x.childCount == y.childCount;
    }));
  }
}

TEST_CASE("sahTopology parts two clusters at the root", "[hulls]") {
  std::vector<Bounds> boxes;
  for (int i = 0; i < 90; ++i) {
    boxes.push_back(boxAt({i % 3 == 0 ? 100.0f : 0.0f, float(i) * 0.01f, 0.0f}, 0.5f));
  }
  const Topology tree = sahTopology(firstPrimitives(90), boxes);
  REQUIRE(tree.nodes[0].childCount == 2);
  CHECK(tree.nodes[tree.nodes[0].firstChild].end == 60);
  for (std::size_t i = 0; i < 60; ++i) CHECK(tree.order[i] % 3 != 0);
}

TEST_CASE("sahTopology costs less than a median cut where density varies", "[hulls]") {
  std::vector<Bounds> boxes = randomBoxes(2000, 4);
  for (std::size_t i = 0; i < boxes.size(); i += 2) {
    boxes[i] = boxAt(glm::vec3(boxes[i].center()) * 0.001f + 3.0f, 1e-4f);
  }
  const auto primitives = firstPrimitives(boxes.size());
  const double sah = sahCost(sahTopology(primitives, boxes), boxes);
  const double median = sahCost(medianTopology(primitives, boxes), boxes);
  CHECK(sah < 0.9 * median);
}

TEST_CASE("medianTopology halves by the centers, along x, y and z in turn", "[hulls]") {
  const std::vector<Bounds> boxes = randomBoxes(1000, 5);
  const Topology tree = medianTopology(firstPrimitives(1000), boxes);
  CHECK(tree.depth == 10);
  std::size_t at = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Topology::Node& left = tree.nodes[tree.nodes[at].firstChild];
    const Topology::Node& right = tree.nodes[tree.nodes[at].firstChild + 1];
    CHECK(right.end - right.begin - (left.end - left.begin) <= 1);
    float highest = -1e9f, lowest = 1e9f;
    for (std::uint32_t i = left.begin; i < right.end; ++i) {
      const float place = boxes[tree.order[i]].center()[axis];
      if (i < left.end) {
        highest = std::max(highest, place);
      } else {
        lowest = std::min(lowest, place);
      }
    }
    CHECK(highest <= lowest);
    at = tree.nodes[at].firstChild;
  }
}

TEST_CASE("medianTopology ends in single primitives", "[hulls]") {
  const Topology tree = medianTopology(firstPrimitives(777), randomBoxes(777, 6));
  for (const Topology::Node& node : tree.nodes) {
    if (node.childCount == 0) CHECK(node.end - node.begin == 1);
  }
}

TEST_CASE("octreeTopology has leaves of at most 8 and parts octants", "[hulls]") {
  const std::vector<Bounds> boxes = randomBoxes(3000, 7);
  const Topology tree = octreeTopology(firstPrimitives(3000), boxes);
  for (const Topology::Node& node : tree.nodes) {
    CHECK(node.childCount <= 8);
    if (node.childCount == 0) CHECK(node.end - node.begin <= 8);
  }
  // At the root, each child's centers are on one side of the middle along each axis.
  for (std::uint32_t child = 0; child < tree.nodes[0].childCount; ++child) {
    const Topology::Node& node = tree.nodes[tree.nodes[0].firstChild + child];
    Bounds centers = Bounds::nothing();
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      centers.add(boxes[tree.order[i]].center());
    }
    for (int axis = 0; axis < 3; ++axis) {
      // The boxes fill the cube from -10 to 10 so well that its middle is near 0.
      CHECK((centers.low[axis] > -0.1f || centers.high[axis] < 0.1f));
    }
  }
}

TEST_CASE("sahCost counts tests by area", "[hulls]") {
  const std::vector<Bounds> boxes = {{{0, 0, 0}, {1, 1, 1}}, {{2, 0, 0}, {3, 1, 1}}};
  Topology leaf;
  leaf.order = {0, 1};
  leaf.nodes = {{0, 2, 0, 0}};
  CHECK(sahCost(leaf, boxes) == Approx(2.0));
  Topology divided = leaf;
  divided.nodes = {{0, 2, 1, 2}, {0, 1, 0, 0}, {1, 2, 0, 0}};
  // The root of half area 7 tests two children; these, of half area 3, a primitive each.
  CHECK(sahCost(divided, boxes) == Approx((7.0 * 2.0 + 3.0 + 3.0) / 7.0));
  const std::vector<Bounds> points(2, {glm::vec3(1.0f), glm::vec3(1.0f)});
  CHECK(sahCost(leaf, points) == 0.0);
}

}  // namespace
}  // namespace twintrace
