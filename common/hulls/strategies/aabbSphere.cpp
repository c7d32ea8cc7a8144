// A box and a sphere for each object: inside both. The README of common/hulls takes it as its example.

#include <algorithm>

#include "common/hulls/volumes/volumes.h"

namespace twintrace {
namespace {

constexpr std::size_t kBoxTexels = 2;

void fit(const HullVolume&, const ShapeRange& shapes, std::span<glm::uvec4> record) {
  const HullVolume box = aabbVolume();
  const HullVolume sphere = sphereVolume();
  box.fit(box, shapes, record.first(kBoxTexels));
  sphere.fit(sphere, shapes, record.subspan(kBoxTexels));
}

/// Of the box or of the sphere, whichever is smaller: an upper bound of what lies in both.
double least(std::span<const glm::uvec4> record,
             double (*HullVolume::*measure)(const HullVolume&, std::span<const glm::uvec4>)) {
  const HullVolume box = aabbVolume();
  const HullVolume sphere = sphereVolume();
  return std::min((box.*measure)(box, record.first(kBoxTexels)),
                  (sphere.*measure)(sphere, record.subspan(kBoxTexels)));
}

double area(const HullVolume&, std::span<const glm::uvec4> record) {
  return least(record, &HullVolume::area);
}

double content(const HullVolume&, std::span<const glm::uvec4> record) {
  return least(record, &HullVolume::content);
}

}  // namespace

void addAabbSphereStrategies(std::vector<HullStrategy>& all) {
  all.push_back({"aabb+sphere", "a box, then a sphere, for each object", HullArrangement::flat,
                 HullGrouping::objects, {"aabbSphere", 3, 1, fit, area, content}});
}

}  // namespace twintrace
