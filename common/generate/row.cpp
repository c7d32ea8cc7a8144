#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "common/cast/case_random.h"
#include "common/generate/recipes.h"

namespace twintrace {
namespace {

constexpr int kBalls = 10;
constexpr double kRadius = 0.075;
constexpr int kOctants = 8;

/// The surface of a ball with six dents and eight bumps, so that no hull is tight: |x| = 1.
double lumpyRadius(const glm::dvec3& x) {
  const glm::dvec3 s = x * x;
  return kRadius * (1.25 - 0.6 * (s.x * s.x + s.y * s.y + s.z * s.z - 1.0 / 3.0));
}

/// One octant of the ball as a triangle of side `cells`, point (i, j, cells - i - j) by its signs.
void addOctant(Mesh& mesh, int cells, const glm::dvec3& signs, const glm::dmat3& turn,
               const glm::dvec3& center) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; i + j <= cells; ++j) {
      const glm::dvec3 direction = glm::normalize(signs * glm::dvec3(i, j, cells - i - j));
      mesh.positions.emplace_back(center + turn * (direction * lumpyRadius(direction)));
    }
  }
  // Row i begins after rows of cells + 1, cells, ... points.
  const auto at = [&](int i, int j) {
    return first + static_cast<std::uint32_t>(i * (cells + 1) - i * (i - 1) / 2 + j);
  };
  const bool mirrored = signs.x * signs.y * signs.z < 0.0;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back(mirrored ? Corners{a, c, b} : Corners{a, b, c});
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; i + j < cells; ++j) {
      add(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + j + 1 < cells) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
}

}  // namespace

std::int64_t rowCount(int levels) {
  return std::int64_t{kBalls * kOctants} << (2 * levels);
}

std::vector<Parts> makeRow(int levels, std::uint32_t seed) {
  std::vector<Parts> objects(kBalls);
  for (int ball = 0; ball < kBalls; ++ball) {
    CaseRandom random(mixSeed(seed, static_cast<std::uint64_t>(ball)));
    const glm::dmat3 turn = random.rotation();
    const glm::dvec3 center(0.2 * ball - 0.9, 0.0, 0.0);
    for (int octant = 0; octant < kOctants; ++octant) {
      const glm::dvec3 signs((octant & 1) != 0 ? -1.0 : 1.0, (octant & 2) != 0 ? -1.0 : 1.0,
                             (octant & 4) != 0 ? -1.0 : 1.0);
      addOctant(objects[static_cast<std::size_t>(ball)].mesh, 1 << levels, signs, turn, center);
    }
  }
  return objects;
}

}  // namespace twintrace
