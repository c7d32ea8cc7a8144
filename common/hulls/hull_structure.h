#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/hulls/topology.h"

namespace twintrace {

/// How nodes are arranged and walked.
/// `wide` is a tree that the C++ tracer makes nodes of eight children of.
enum class HullArrangement { none, flat, tree, heap, wide };

/// What contains a range of primitives: one kind of hull, on the host's side. Its record's layout and
/// its test by rays are in shaders/hulls/volumes/NAME.glsl and cpu/kernel/hulls/volumes/NAME.h.
struct HullVolume {
  std::string_view name;
  int texels = 0;  ///< of a record, given `groups` groups of slabs
  int groups = 1;
  /// Writes the record of a hull of all these shapes.
  void (*fit)(const HullVolume& volume, const ShapeRange& shapes, std::span<glm::uvec4> record);
  /// Surface area and volume of a record's hull.
  double (*area)(const HullVolume& volume, std::span<const glm::uvec4> record);
  double (*content)(const HullVolume& volume, std::span<const glm::uvec4> record);
  std::uint32_t slabs = 0;  ///< of k-DOPs: a bit for each normal used
};

/// What lies in a hull: nodes if `inner`, else references.
struct HullLink {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool inner = false;
};

/// All hulls of a scene as tracers read them: nodes of a record and a link, then references, four in a
/// texel. Link: first child or reference, count, 1 for an inner node.
struct HullStructure {
  std::string strategy;
  HullArrangement arrangement = HullArrangement::none;
  HullVolume volume;
  int nodeTexels = 0;
  int nodeCount = 0;
  int referenceOffset = 0;
  float reach = 0.0f;  ///< largest coordinate of what is contained
  int depth = 0;
  double buildSeconds = 0.0;
  double sahCost = 0.0;
  std::vector<glm::uvec4> texels;

  std::size_t bytes() const { return texels.size() * sizeof(glm::uvec4); }
  std::span<const glm::uvec4> record(int node) const {
    return std::span(texels).subspan(static_cast<std::size_t>(node) *
                                         static_cast<std::size_t>(nodeTexels),
                                     static_cast<std::size_t>(nodeTexels) - 1);
  }
  HullLink link(int node) const {
    const glm::uvec4& texel = texels[static_cast<std::size_t>(node + 1) *
                                         static_cast<std::size_t>(nodeTexels) - 1];
    return {texel.x, texel.y, texel.z != 0u};
  }
  /// The primitives of a node, through all that lies below it.
  std::vector<std::uint32_t> primitivesBelow(int node) const;
  std::uint32_t reference(std::uint32_t i) const {
    return texels[static_cast<std::size_t>(referenceOffset) + i / 4][static_cast<int>(i % 4)];
  }
};

/// How primitives are brought into groups.
enum class HullGrouping { objects, sah, median, octree };

/// A way to build hulls, by its name on the command line.
struct HullStrategy {
  std::string name;
  std::string what;  ///< for --help and tables
  HullArrangement arrangement = HullArrangement::none;
  HullGrouping grouping = HullGrouping::objects;
  HullVolume volume;
};

/// Every strategy; those of wide nodes are the C++ tracer's alone.
const std::vector<HullStrategy>& hullStrategies();

/// The strategy of that name, or null.
const HullStrategy* findHullStrategy(std::string_view name);

/// The hulls that the options ask for, or null if every primitive is to be tested, or Embree asked.
std::shared_ptr<const HullStructure> chosenHulls(const FlatScene& scene,
                                                 const RenderOptions& options);

/// Name of the strategy of a scene's hulls, or "none".
std::string hullName(const FlatScene& scene);

/// Primitives with bounds, of the kinds that the scene's effects leave in.
std::vector<std::uint32_t> boundedPrimitives(const FlatScene& scene);

/// Builds the hulls of all bounded primitives that the scene's effects leave in, in parallel.
HullStructure buildHulls(const FlatScene& scene, const HullStrategy& strategy);

}  // namespace twintrace
