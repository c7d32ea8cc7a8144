#include <algorithm>
#include <array>
#include <limits>

#include "common/hulls/polytope.h"
#include "common/hulls/volumes/kdop.h"
#include "common/hulls/volumes/record.h"

namespace twintrace {
namespace {

constexpr std::array<glm::dvec3, kMostSlabs> kNormals = {{{1, 0, 0},
                                                          {0, 1, 0},
                                                          {0, 0, 1},
                                                          {1, 1, 1},
                                                          {1, 1, -1},
                                                          {1, -1, 1},
                                                          {-1, 1, 1},
                                                          {1, 1, 0},
                                                          {1, -1, 0},
                                                          {1, 0, 1},
                                                          {1, 0, -1},
                                                          {0, 1, 1},
                                                          {0, 1, -1}}};
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Slabs that a record has room for but that are not used hold everything.
void fit(const HullVolume& volume, const ShapeRange& shapes,
         std::span<glm::uvec4> record) {
  for (int group = 0; group < volume.groups; ++group) {
    glm::vec3 low(-kInfinity);
    glm::vec3 high(kInfinity);
    for (int i = 0; i < 3; ++i) {
      const int slab = std::min(3 * group + i, kMostSlabs - 1);
      if (!usesSlab(volume, slab)) continue;
      const glm::dvec3& n = kNormals[static_cast<std::size_t>(slab)];
      double most = -std::numeric_limits<double>::infinity();
      double least = most;
      for (const ConvexShape& shape : shapes) {
        most = std::max(most, shape.support(n));
        least = std::max(least, shape.support(-n));
      }
      low[i] = roundedDown(-least);
      high[i] = roundedUp(most);
    }
    record[static_cast<std::size_t>(2 * group)] = recordTexel(low);
    record[static_cast<std::size_t>(2 * group + 1)] = recordTexel(high);
  }
}

PolytopeMeasure measure(const HullVolume& volume, std::span<const glm::uvec4> record) {
  std::vector<HalfSpace> spaces;
  for (int slab = 0; slab < std::min(3 * volume.groups, kMostSlabs); ++slab) {
    if (!usesSlab(volume, slab)) continue;
    const auto at = static_cast<std::size_t>(2 * (slab / 3));
    const glm::dvec3& n = kNormals[static_cast<std::size_t>(slab)];
    spaces.push_back({n, recordVector(record[at + 1])[slab % 3]});
    spaces.push_back({-n, -recordVector(record[at])[slab % 3]});
  }
  return measurePolytope(spaces);
}

double area(const HullVolume& volume, std::span<const glm::uvec4> record) {
  return measure(volume, record).area;
}

double content(const HullVolume& volume, std::span<const glm::uvec4> record) {
  return measure(volume, record).content;
}

}  // namespace

bool usesSlab(const HullVolume& volume, int slab) {
  return ((volume.slabs >> slab) & 1u) != 0;
}

HullVolume kdopVolume(std::uint32_t slabs) {
  int groups = 1;
  for (int slab = 0; slab < kMostSlabs; ++slab) {
    if (((slabs >> slab) & 1u) != 0) groups = slab / 3 + 1;
  }
  return {"kdop", 2 * groups, groups, fit, area, content, slabs};
}

}  // namespace twintrace
