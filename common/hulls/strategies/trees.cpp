// Trees of hulls, entered from near to far.

#include "common/hulls/volumes/volumes.h"

namespace twintrace {
namespace {

HullStrategy tree(std::string name, std::string what, HullGrouping grouping,
                  const HullVolume& volume) {
  return {std::move(name), std::move(what), HullArrangement::tree, grouping, volume};
}

}  // namespace

void addTreesStrategies(std::vector<HullStrategy>& all) {
  all.push_back(tree("bvh", "boxes, surface area heuristic", HullGrouping::sah, aabbVolume()));
  all.push_back(tree("bvh-median", "boxes, median cut", HullGrouping::median, aabbVolume()));
  all.push_back(
      tree("bvh-sphere", "spheres, surface area heuristic", HullGrouping::sah, sphereVolume()));
  all.push_back(
      tree("bvh-obb", "oriented boxes, surface area heuristic", HullGrouping::sah, obbVolume()));
  all.push_back({"kay-kajiya-tree", "7 slabs, median cut, a heap by entry distance",
                 HullArrangement::heap, HullGrouping::median, kdopVolume(kAxes | kCubeDiagonals)});
  all.push_back({"bvh8", "boxes, eight at a time, surface area heuristic; cpu only",
                 HullArrangement::wide, HullGrouping::sah, aabbVolume()});
  all.push_back(tree("octree", "boxes, grouped by octants", HullGrouping::octree, aabbVolume()));
}

}  // namespace twintrace
