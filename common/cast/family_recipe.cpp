#include "common/cast/family_recipe.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>

namespace twintrace {
namespace {

CasePrimitive make(CaseKind kind, std::initializer_list<glm::dvec3> vectors) {
  CasePrimitive primitive;
  primitive.kind = kind;
  int at = 0;
  for (const glm::dvec3& v : vectors) {
    for (int axis = 0; axis < 3; ++axis) {
      primitive.values[at++] = static_cast<float>(v[axis]);
    }
  }
  return normalised(primitive);
}

CasePrimitive movedBox(const CasePrimitive& box, const glm::dmat3& rotation,
                       const glm::dvec3& offset) {
  const glm::dvec3 low(box.vector(0));
  const glm::dvec3 high(box.vector(3));
  return orientedBoxOf(rotation * (0.5 * (low + high)) + offset, rotation, 0.5 * (high - low));
}

CasePrimitive movedOrientedBox(const CasePrimitive& box, const glm::dmat3& rotation,
                               const glm::dvec3& offset) {
  const glm::dmat3 axes(box.vector(3), box.vector(6), box.vector(9));
  return orientedBoxOf(rotation * glm::dvec3(box.vector(0)) + offset, rotation * axes,
                       glm::dvec3(box.vector(12)));
}

CasePrimitive movedPrimitive(const CasePrimitive& p, const glm::dmat3& rotation,
                             const glm::dvec3& offset) {
  const auto point = [&](int first) { return rotation * glm::dvec3(p.vector(first)) + offset; };
  switch (p.kind) {
    case CaseKind::sphere:
      return sphereOf(point(0), p.values[3]);
    case CaseKind::box:
      return movedBox(p, rotation, offset);
    case CaseKind::orientedBox:
      return movedOrientedBox(p, rotation, offset);
    case CaseKind::plane:
      return planeOf(rotation * glm::dvec3(p.vector(0)), point(3));
    case CaseKind::triangle:
      return triangleOf(point(0), point(3), point(6));
  }
  return p;
}

}  // namespace

CasePrimitive sphereOf(const glm::dvec3& centre, double radius) {
  return make(CaseKind::sphere, {centre, glm::dvec3(radius, 0.0, 0.0)});
}

CasePrimitive boxOf(const glm::dvec3& low, const glm::dvec3& high) {
  return make(CaseKind::box, {low, high});
}

CasePrimitive orientedBoxOf(const glm::dvec3& centre, const glm::dmat3& axes,
                            const glm::dvec3& halfSizes) {
  return make(CaseKind::orientedBox, {centre, axes[0], axes[1], axes[2], halfSizes});
}

CasePrimitive planeOf(const glm::dvec3& normal, const glm::dvec3& point) {
  return make(CaseKind::plane, {normal, point});
}

CasePrimitive triangleOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return make(CaseKind::triangle, {a, b, c});
}

CastRay rayOf(const glm::dvec3& origin, const glm::dvec3& direction) {
  CastRay ray;
  ray.origin = glm::vec3(origin);
  ray.direction = glm::vec3(direction);
  return ray;
}

CastRay rayTowards(const glm::dvec3& origin, const glm::dvec3& target) {
  const glm::dvec3 rounded = glm::dvec3(glm::vec3(origin));
  const glm::dvec3 d = target - rounded;
  return rayOf(rounded, d / std::sqrt(glm::dot(d, d)));
}

Case moved(const Case& given, const glm::dmat3& rotation, const glm::dvec3& offset) {
  Case result = given;
  for (CasePrimitive& primitive : result.primitives) {
    primitive = movedPrimitive(primitive, rotation, offset);
  }
  result.ray.origin = glm::vec3(rotation * glm::dvec3(given.ray.origin) + offset);
  result.ray.direction = glm::vec3(rotation * glm::dvec3(given.ray.direction));
  return result;
}

}  // namespace twintrace
