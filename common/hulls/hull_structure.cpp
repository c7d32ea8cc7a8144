#include "common/hulls/hull_structure.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "common/base/parallel_for.h"

namespace twintrace {
namespace {

std::vector<Bounds> allBounds(const FlatScene& scene) {
  std::vector<Bounds> bounds(static_cast<std::size_t>(scene.index.boundedCount()));
  parallelFor(tbb::blocked_range<std::size_t>(0, bounds.size()), [&](const auto& part) {
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      bounds[i] = boundsOf(convexShape(scene, static_cast<int>(i)));
    }
  });
  return bounds;
}

/// One node for each object that has such primitives.
Topology objectTopology(const FlatScene& scene, std::span<const std::uint32_t> primitives) {
  Topology result;
  result.order.assign(primitives.begin(), primitives.end());
  const auto objectOf = [&](std::uint32_t primitive) { return scene.primitiveObject[primitive]; };
  std::ranges::stable_sort(result.order, {}, objectOf);
  for (std::uint32_t i = 0; i < result.order.size(); ++i) {
    const bool begins = i == 0 || objectOf(result.order[i]) != objectOf(result.order[i - 1]);
    if (begins) result.nodes.push_back({i, i, 0, 0});
    result.nodes.back().end = i + 1;
  }
  return result;
}

Topology topologyOf(const FlatScene& scene, HullGrouping grouping,
                    std::span<const std::uint32_t> primitives, std::span<const Bounds> bounds) {
  switch (grouping) {
    case HullGrouping::sah:
      return sahTopology(primitives, bounds);
    case HullGrouping::median:
      return medianTopology(primitives, bounds);
    case HullGrouping::octree:
      return octreeTopology(primitives, bounds);
    case HullGrouping::objects:
      break;
  }
  return objectTopology(scene, primitives);
}

float reachOf(std::span<const std::uint32_t> primitives, std::span<const Bounds> bounds) {
  float reach = 0.0f;
  for (const std::uint32_t primitive : primitives) {
    const Bounds& b = bounds[primitive];
    for (int i = 0; i < 3; ++i) reach = std::max({reach, std::abs(b.low[i]), std::abs(b.high[i])});
  }
  return reach;
}

glm::uvec4 linkOf(const Topology::Node& node) {
  if (node.childCount == 0) return {node.begin, node.end - node.begin, 0u, 0u};
  return {node.firstChild, node.childCount, 1u, 0u};
}

void writeNodes(const FlatScene& scene, const Topology& topology, HullStructure& hulls) {
  const auto stride = static_cast<std::size_t>(hulls.nodeTexels);
  const std::span<const std::uint32_t> order(topology.order);
  parallelFor(tbb::blocked_range<std::size_t>(0, topology.nodes.size()), [&](const auto& part) {
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      const Topology::Node& node = topology.nodes[i];
      const std::span<glm::uvec4> texels = std::span(hulls.texels).subspan(i * stride, stride);
      const ShapeRange shapes(scene, order.subspan(node.begin, node.end - node.begin));
      hulls.volume.fit(hulls.volume, shapes, texels.first(stride - 1));
      texels[stride - 1] = linkOf(node);
    }
  });
}

void writeReferences(const Topology& topology, HullStructure& hulls) {
  const auto first = static_cast<std::size_t>(hulls.referenceOffset);
  for (std::size_t i = 0; i < topology.order.size(); ++i) {
    hulls.texels[first + i / 4][static_cast<int>(i % 4)] = topology.order[i];
  }
}

/// Adds the primitives of a node and of all below it.
void collect(const HullStructure& hulls, int node, std::vector<std::uint32_t>& primitives) {
  const HullLink link = hulls.link(node);
  for (std::uint32_t i = link.first; i < link.first + link.count; ++i) {
    if (link.inner) {
      collect(hulls, static_cast<int>(i), primitives);
    } else {
      primitives.push_back(hulls.reference(i));
    }
  }
}

}  // namespace

std::vector<std::uint32_t> HullStructure::primitivesBelow(int node) const {
  std::vector<std::uint32_t> primitives;
  collect(*this, node, primitives);
  return primitives;
}

std::vector<std::uint32_t> boundedPrimitives(const FlatScene& scene) {
  std::vector<std::uint32_t> result;
  std::uint32_t first = 0;
  const auto add = [&](Effect effect, int count) {
    for (int i = 0; scene.effects.has(effect) && i < count; ++i) result.push_back(first + i);
    first += static_cast<std::uint32_t>(count);
  };
  add(Effect::sphere, scene.index.sphereCount);
  add(Effect::box, scene.index.boxCount);
  add(Effect::orientedBox, scene.index.orientedBoxCount);
  add(Effect::triangle, scene.index.triangleCount);
  return result;
}

HullStructure buildHulls(const FlatScene& scene, const HullStrategy& strategy) {
  const auto start = std::chrono::steady_clock::now();
  HullStructure hulls;
  hulls.strategy = strategy.name;
  hulls.volume = strategy.volume;
  const std::vector<std::uint32_t> primitives = boundedPrimitives(scene);
  if (strategy.arrangement == HullArrangement::none || primitives.empty()) return hulls;
  const std::vector<Bounds> bounds = allBounds(scene);
  const Topology topology = topologyOf(scene, strategy.grouping, primitives, bounds);
  hulls.arrangement = strategy.arrangement;
  hulls.nodeTexels = strategy.volume.texels + 1;
  hulls.nodeCount = static_cast<int>(topology.nodes.size());
  hulls.referenceOffset = hulls.nodeCount * hulls.nodeTexels;
  hulls.reach = reachOf(primitives, bounds);
  hulls.depth = topology.depth;
  hulls.texels.resize(static_cast<std::size_t>(hulls.referenceOffset) +
                      (topology.order.size() + 3) / 4);
  writeNodes(scene, topology, hulls);
  writeReferences(topology, hulls);
  if (strategy.arrangement != HullArrangement::flat) hulls.sahCost = sahCost(topology, bounds);
  hulls.buildSeconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return hulls;
}

}  // namespace twintrace
