#include "common/cast/case_set.h"

#include <cmath>
#include <utility>

namespace twintrace {
namespace {

float withoutDenormal(float x) {
  return std::fpclassify(x) == FP_SUBNORMAL ? std::copysign(0.0f, x) : x;
}

void putInOrder(float& low, float& high) {
  if (low > high) std::swap(low, high);
}

glm::vec3 withoutDenormals(const glm::vec3& v) {
  return {withoutDenormal(v.x), withoutDenormal(v.y), withoutDenormal(v.z)};
}

}  // namespace

int valueCount(CaseKind kind) {
  switch (kind) {
    case CaseKind::sphere:
      return 4;
    case CaseKind::box:
    case CaseKind::plane:
      return 6;
    case CaseKind::orientedBox:
      return 15;
    case CaseKind::triangle:
      return 9;
  }
  return 0;
}

CasePrimitive normalised(CasePrimitive primitive) {
  for (float& value : primitive.values) value = withoutDenormal(value);
  auto& v = primitive.values;
  if (primitive.kind == CaseKind::sphere) v[3] = std::fabs(v[3]);
  if (primitive.kind == CaseKind::box) {
    for (int axis = 0; axis < 3; ++axis) putInOrder(v[axis], v[axis + 3]);
  }
  if (primitive.kind == CaseKind::orientedBox) {
    for (int axis = 12; axis < 15; ++axis) v[axis] = std::fabs(v[axis]);
  }
  return primitive;
}

CastRay normalised(CastRay ray) {
  ray.origin = withoutDenormals(ray.origin);
  ray.direction = withoutDenormals(ray.direction);
  ray.tmin = withoutDenormal(ray.tmin);
  ray.tmax = withoutDenormal(ray.tmax);
  return ray;
}

}  // namespace twintrace
