#include <bit>

#include "common/hulls/volumes/record.h"

namespace twintrace {
namespace {

void fit(const HullVolume&, const ShapeRange& shapes, std::span<glm::uvec4> record) {
  Bounds bounds = Bounds::nothing();
  for (const ConvexShape& shape : shapes) bounds.add(boundsOf(shape));
  record[0] = recordTexel(bounds.low);
  record[1] = recordTexel(bounds.high);
}

glm::dvec3 sizeOf(std::span<const glm::uvec4> record) {
  return recordVector(record[1]) - recordVector(record[0]);
}

double area(const HullVolume&, std::span<const glm::uvec4> record) {
  const glm::dvec3 s = sizeOf(record);
  return 2.0 * (s.x * s.y + s.y * s.z + s.z * s.x);
}

double content(const HullVolume&, std::span<const glm::uvec4> record) {
  const glm::dvec3 s = sizeOf(record);
  return s.x * s.y * s.z;
}

}  // namespace

HullVolume aabbVolume() {
  return {"aabb", 2, 1, fit, area, content};
}

}  // namespace twintrace
