#include <cmath>
#include <glm/mat3x3.hpp>

#include "common/generate/recipes.h"

namespace twintrace {
namespace {

constexpr double kShrink = 1.0 / 3.0;
constexpr int kChildren = 9;

/// Towards the children of a sphere that grows along +z: six around its equator, three above.
std::array<glm::dvec3, kChildren> childDirections() {
  const double half = 0.5, side = std::sqrt(0.75);
  const double out = std::sqrt(1.0 / 3.0), up = std::sqrt(2.0 / 3.0);
  return {{{1.0, 0.0, 0.0},
           {half, side, 0.0},
           {-half, side, 0.0},
           {-1.0, 0.0, 0.0},
           {-half, -side, 0.0},
           {half, -side, 0.0},
           {side * out, half * out, up},
           {-side * out, half * out, up},
           {0.0, -out, up}}};
}

/// The shortest rotation of +z to a unit vector.
glm::dmat3 rotationTo(const glm::dvec3& d) {
  if (d.z < -1.0 + 1e-12) return {{-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};
  const double k = 1.0 / (1.0 + d.z);
  return {{1.0 - d.x * d.x * k, -d.x * d.y * k, -d.x},
          {-d.x * d.y * k, 1.0 - d.y * d.y * k, -d.y},
          {d.x, d.y, d.z}};
}

class Flake {
 public:
  explicit Flake(std::vector<SphereShape>& spheres) : spheres_(spheres) {}

  /// z is up while it grows, y in the scene.
  void grow(const glm::dvec3& center, double radius, const glm::dvec3& along, int levels) {
    spheres_.push_back({{float(center.x), float(center.z), float(-center.y)}, float(radius)});
    if (levels == 0) return;
    const glm::dmat3 frame = rotationTo(along);
    const double childRadius = radius * kShrink;
    for (const glm::dvec3& local : directions_) {
      const glm::dvec3 direction = frame * local;
      grow(center + direction * (radius + childRadius), childRadius, direction, levels - 1);
    }
  }

 private:
  const std::array<glm::dvec3, kChildren> directions_ = childDirections();
  std::vector<SphereShape>& spheres_;
};

}  // namespace

std::int64_t sphereflakeCount(int levels) {
  std::int64_t count = 1;
  for (int i = 0; i < levels; ++i) count = count * kChildren + 1;
  return count;
}

std::vector<Parts> makeSphereflake(int levels, std::uint32_t) {
  std::vector<Parts> objects(1);
  objects[0].spheres.reserve(static_cast<std::size_t>(sphereflakeCount(levels)));
  Flake(objects[0].spheres).grow(glm::dvec3(0.0), 0.5, {0.0, 0.0, 1.0}, levels);
  return objects;
}

}  // namespace twintrace
