#include "common/hulls/convex_shape.h"

#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "common/scene/layout.h"

namespace twintrace {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Reads records of the flat scene.
class Records {
 public:
  explicit Records(const FlatScene& scene) : scene_(scene) {}

  glm::dvec3 vector(int texel) const {
    return {number(texel, 0), number(texel, 1), number(texel, 2)};
  }
  double number(int texel, int component) const {
    const glm::uvec4& words = scene_.texels[static_cast<std::size_t>(texel)];
    return std::bit_cast<float>(words[component]);
  }

 private:
  const FlatScene& scene_;
};

ConvexShape boxShape(const glm::dvec3& low, const glm::dvec3& high) {
  ConvexShape shape;
  for (int i = 0; i < 8; ++i) {
    shape.points[static_cast<std::size_t>(shape.count++)] = {
        (i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
  }
  return shape;
}

/// The box |axis . (p - center)| <= half, as the tracers test it: its axes are orthonormal to within
/// rounding only.
ConvexShape orientedBoxShape(const Records& records, int at) {
  const glm::dvec3 center = records.vector(at);
  const glm::dmat3 axes(records.vector(at + 1), records.vector(at + 2), records.vector(at + 3));
  const glm::dvec3 half = records.vector(at + 4);
  const glm::dmat3 toWorld = glm::inverse(glm::transpose(axes));
  ConvexShape shape = boxShape(-half, half);
  for (glm::dvec3& point : shape.points) point = center + toWorld * point;
  return shape;
}

}  // namespace

double ConvexShape::support(const glm::dvec3& n) const {
  double result = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i) {
    result = std::max(result, glm::dot(n, points[static_cast<std::size_t>(i)]));
  }
  return result + radius * glm::length(n);
}

ConvexShape convexShape(const FlatScene& scene, int primitive) {
  const Records records(scene);
  const SceneIndex& index = scene.index;
  int i = primitive;
  if (i < index.sphereCount) {
    const int at = index.sphereOffset + i * layout::kSphereTexels;
    return {{records.vector(at)}, 1, std::fabs(records.number(at, 3))};
  }
  i -= index.sphereCount;
  if (i < index.boxCount) {
    const int at = index.boxOffset + i * layout::kBoxTexels;
    return boxShape(records.vector(at), records.vector(at + 1));
  }
  i -= index.boxCount;
  if (i < index.orientedBoxCount) {
    return orientedBoxShape(records, index.orientedBoxOffset + i * layout::kOrientedBoxTexels);
  }
  i -= index.orientedBoxCount;
  const int at = index.triangleOffset + i * layout::kTriangleTexels;
  return {{records.vector(at), records.vector(at + 1), records.vector(at + 2)}, 3, 0.0};
}

float roundedDown(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest > x ? std::nextafter(nearest, -kInfinity) : nearest;
}

float roundedUp(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest < x ? std::nextafter(nearest, kInfinity) : nearest;
}

Bounds Bounds::nothing() {
  return {glm::vec3(kInfinity), glm::vec3(-kInfinity)};
}

void Bounds::add(const Bounds& other) {
  low = glm::min(low, other.low);
  high = glm::max(high, other.high);
}

void Bounds::add(const glm::vec3& point) {
  low = glm::min(low, point);
  high = glm::max(high, point);
}

float Bounds::halfArea() const {
  const glm::vec3 size = glm::max(high - low, glm::vec3(0.0f));
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

Bounds boundsOf(const ConvexShape& shape) {
  Bounds bounds = Bounds::nothing();
  for (int i = 0; i < shape.count; ++i) {
    const glm::dvec3& p = shape.points[static_cast<std::size_t>(i)];
    const double r = shape.radius;
    bounds.add(glm::vec3(roundedDown(p.x - r), roundedDown(p.y - r), roundedDown(p.z - r)));
    bounds.add(glm::vec3(roundedUp(p.x + r), roundedUp(p.y + r), roundedUp(p.z + r)));
  }
  return bounds;
}

}  // namespace twintrace
