#include "common/cast/case_random.h"
#include "common/generate/recipes.h"

namespace twintrace {
namespace {

constexpr double kRoughness = 0.45;  // height of the first displacement, in half widths
constexpr double kSmoothing = 0.5;   // of the displacement from level to level

/// Heights over a square grid of 2^levels cells a side.
class HeightField {
 public:
  HeightField(int levels, std::uint32_t seed)
      : cells_(1 << levels),
        seed_(seed),
        heights_(static_cast<std::size_t>(cells_ + 1) * static_cast<std::size_t>(cells_ + 1)) {
    double amplitude = kRoughness;
    for (int step = cells_ / 2; step >= 1; step /= 2, amplitude *= kSmoothing) {
      displace(step, amplitude);
    }
  }

  int cells() const { return cells_; }
  double at(int x, int z) const { return heights_[index(x, z)]; }

 private:
  std::size_t index(int x, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_ + 1) +
           static_cast<std::size_t>(x);
  }

  /// The middles of all edges between points 2 `step` apart, along x, z and the cells' diagonal.
  void displace(int step, double amplitude) {
    for (int z = 0; z <= cells_; z += step) {
      for (int x = 0; x <= cells_; x += step) {
        const int dx = x / step % 2 * step;
        const int dz = z / step % 2 * step;
        if (dx == 0 && dz == 0) continue;
        const double middle = (at(x - dx, z - dz) + at(x + dx, z + dz)) / 2.0;
        CaseRandom random(mixSeed(seed_, index(x, z)));
        heights_[index(x, z)] = middle + amplitude * random.uniform(-1.0, 1.0);
      }
    }
  }

  int cells_;
  std::uint64_t seed_;
  std::vector<double> heights_;
};

void addVertices(const HeightField& field, Mesh& mesh) {
  const double cells = field.cells();
  for (int z = 0; z <= field.cells(); ++z) {
    for (int x = 0; x <= field.cells(); ++x) {
      const double u = x / cells, v = z / cells;
      mesh.positions.emplace_back(2.0 * u - 1.0, field.at(x, z), 2.0 * v - 1.0);
      mesh.textureCoordinates.emplace_back(u, v);
    }
  }
}

}  // namespace

std::int64_t mountCount(int levels) {
  return std::int64_t{2} << (2 * levels);
}

std::vector<Parts> makeMount(int levels, std::uint32_t seed) {
  std::vector<Parts> objects(1);
  Mesh& mesh = objects[0].mesh;
  const HeightField field(levels, seed);
  addVertices(field, mesh);
  const auto side = static_cast<std::uint32_t>(field.cells()) + 1;
  mesh.triangles.reserve(static_cast<std::size_t>(mountCount(levels)));
  for (std::uint32_t z = 0; z + 1 < side; ++z) {
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t here = z * side + x;
      mesh.triangles.push_back({here, here + side, here + side + 1});
      mesh.triangles.push_back({here, here + side + 1, here + 1});
    }
  }
  return objects;
}

}  // namespace twintrace
