// One hull for each object, tested without any order.

#include "common/hulls/volumes/volumes.h"

namespace twintrace {
namespace {

HullStrategy flat(std::string name, std::string what, const HullVolume& volume) {
  return {std::move(name), std::move(what), HullArrangement::flat, HullGrouping::objects, volume};
}

}  // namespace

void addFlatStrategies(std::vector<HullStrategy>& all) {
  all.push_back(flat("sphere", "a sphere for each object", sphereVolume()));
  all.push_back(flat("aabb", "an axis-aligned box for each object", aabbVolume()));
  all.push_back(flat("obb", "an oriented box for each object", obbVolume()));
  all.push_back(flat("kdop6", "3 slabs for each object: the axes", kdopVolume(kAxes)));
  all.push_back(
      flat("kdop8", "4 slabs for each object: the cube's diagonals", kdopVolume(kCubeDiagonals)));
  all.push_back(flat("kdop14", "7 slabs for each object", kdopVolume(kAxes | kCubeDiagonals)));
  all.push_back(flat("kdop18", "9 slabs for each object", kdopVolume(kAxes | kFaceDiagonals)));
  all.push_back(flat("kdop26", "13 slabs for each object",
                     kdopVolume(kAxes | kCubeDiagonals | kFaceDiagonals)));
  all.push_back(flat("kay-kajiya", "the 7 slabs of the paper for each object",
                     kdopVolume(kAxes | kCubeDiagonals)));
}

}  // namespace twintrace
