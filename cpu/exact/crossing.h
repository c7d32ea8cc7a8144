#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "common/cast/case_set.h"
#include "cpu/exact/root.h"

namespace twintrace::exact {

template <class N>
using Vector = std::array<N, 3>;

template <class N>
Vector<N> toVector(const glm::vec3& v) {
  return {N(v.x), N(v.y), N(v.z)};
}

template <class N>
Vector<N> operator-(const Vector<N>& a, const Vector<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A ray with finite numbers; its interval ends at the largest float on either side.
template <class N>
struct Ray {
  explicit Ray(const CastRay& ray)
      : origin(toVector<N>(ray.origin)),
        direction(toVector<N>(ray.direction)),
        tmin{N(std::fmax(ray.tmin, -std::numeric_limits<float>::max())), N(1.0f)},
        tmax{N(std::fmin(ray.tmax, std::numeric_limits<float>::max())), N(1.0f)} {}

  bool reaches(const Root<N>& t) const { return compare(t, tmin) >= 0 && compare(t, tmax) <= 0; }

  Vector<N> origin;
  Vector<N> direction;
  Root<N> tmin;
  Root<N> tmax;
};

/// Where a ray crosses a primitive's surface.
template <class N>
struct Crossing {
  Root<N> t;
  bool leaving = false;
  int axis = 0;  ///< of boxes: the slab, the first of those crossed at the same t
  int side = 0;  ///< of boxes: -1 at the slab's lower bound, 1 at its upper one
};

/// The first of a solid's two crossings within the ray's interval.
template <class N>
std::optional<Crossing<N>> firstReached(const Crossing<N>& entry, const Crossing<N>& exit,
                                        const Ray<N>& ray) {
  if (ray.reaches(entry.t)) return entry;
  if (ray.reaches(exit.t)) return exit;
  return std::nullopt;
}

/// With f from origin to centre: t = (f.d +- sqrt(d.d r^2 - |d x f|^2)) / d.d, the discriminant in
/// the distance form, which cancels only at tangents (Haines et al., Ray Tracing Gems ch. 7).
template <class N>
std::optional<Crossing<N>> crossSphere(const CasePrimitive& sphere, const Ray<N>& ray) {
  const N radius(sphere.values[3]);
  const Vector<N> f = toVector<N>(sphere.vector(0)) - ray.origin;
  const Vector<N> offset = cross(ray.direction, f);
  const N q = dot(ray.direction, ray.direction);
  const N d = q * radius * radius - dot(offset, offset);
  if (d.sign() < 0) return std::nullopt;
  const N p = dot(f, ray.direction);
  return firstReached<N>({{p, q, -1, d}, false}, {{p, q, 1, d}, true}, ray);
}

/// low <= position + t slope <= high
template <class N>
struct Slab {
  N low;
  N high;
  N position;
  N slope;
};

/// Intersection of three closed slabs (Kay and Kajiya 1986), without division.
template <class N>
std::optional<Crossing<N>> crossSlabs(const std::array<Slab<N>, 3>& slabs, const Ray<N>& ray) {
  std::optional<Crossing<N>> entry;
  std::optional<Crossing<N>> exit;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& [low, high, position, slope] = slabs[axis];
    const int side = slope.sign();
    if (side == 0) {
      if ((position - low).sign() < 0 || (position - high).sign() > 0) return std::nullopt;
      continue;
    }
    const N q = side > 0 ? slope : -slope;
    const Root<N> near{side > 0 ? low - position : position - high, q};
    const Root<N> far{side > 0 ? high - position : position - low, q};
    if (!entry || compare(near, entry->t) > 0) entry = {near, false, axis, -side};
    if (!exit || compare(far, exit->t) < 0) exit = {far, true, axis, side};
  }
  if (!entry || compare(entry->t, exit->t) > 0) return std::nullopt;
  return firstReached(*entry, *exit, ray);
}

template <class N>
std::optional<Crossing<N>> crossBox(const CasePrimitive& box, const Ray<N>& ray) {
  const auto slab = [&](int axis) -> Slab<N> {
    return {N(box.values[axis]), N(box.values[axis + 3]), ray.origin[axis], ray.direction[axis]};
  };
  return crossSlabs<N>({slab(0), slab(1), slab(2)}, ray);
}

/// The points p with |axis . (p - centre)| <= half size for each axis as given.
template <class N>
std::optional<Crossing<N>> crossOrientedBox(const CasePrimitive& box, const Ray<N>& ray) {
  const Vector<N> origin = ray.origin - toVector<N>(box.vector(0));
  const auto slab = [&](int index) -> Slab<N> {
    const Vector<N> axis = toVector<N>(box.vector(3 + 3 * index));
    const float half = box.values[12 + index];
    return {N(-half), N(half), dot(axis, origin), dot(axis, ray.direction)};
  };
  return crossSlabs<N>({slab(0), slab(1), slab(2)}, ray);
}

/// Where n . (point - origin - t direction) = 0; nothing along the plane.
template <class N>
std::optional<Crossing<N>> crossPlane(const Vector<N>& normal, const Vector<N>& point,
                                      const Ray<N>& ray) {
  const N slope = dot(normal, ray.direction);
  const int side = slope.sign();
  if (side == 0) return std::nullopt;
  const N height = dot(normal, point - ray.origin);
  const Crossing<N> crossing{{side > 0 ? height : -height, side > 0 ? slope : -slope}};
  if (!ray.reaches(crossing.t)) return std::nullopt;
  return crossing;
}

/// The three edge functions d . (a x b), vertices relative to the origin, none of the other sign
/// than their sum, which is n . d (Woop et al. 2013, here exact). No area: n = 0, so a miss.
template <class N>
std::optional<Crossing<N>> crossTriangle(const CasePrimitive& triangle, const Ray<N>& ray) {
  const Vector<N> a = toVector<N>(triangle.vector(0)) - ray.origin;
  const Vector<N> b = toVector<N>(triangle.vector(3)) - ray.origin;
  const Vector<N> c = toVector<N>(triangle.vector(6)) - ray.origin;
  const int ab = dot(ray.direction, cross(a, b)).sign();
  const int bc = dot(ray.direction, cross(b, c)).sign();
  const int ca = dot(ray.direction, cross(c, a)).sign();
  const bool outside = (ab < 0 || bc < 0 || ca < 0) && (ab > 0 || bc > 0 || ca > 0);
  if (outside) return std::nullopt;
  const Vector<N> v0 = toVector<N>(triangle.vector(0));
  const Vector<N> normal =
      cross(toVector<N>(triangle.vector(3)) - v0, toVector<N>(triangle.vector(6)) - v0);
  return crossPlane(normal, v0, ray);
}

/// The first crossing of the primitive within the ray's interval.
/// @throws Uncertain if the number cannot decide.
template <class N>
std::optional<Crossing<N>> firstCrossing(const CasePrimitive& primitive, const Ray<N>& ray) {
  switch (primitive.kind) {
    case CaseKind::sphere:
      return crossSphere(primitive, ray);
    case CaseKind::box:
      return crossBox(primitive, ray);
    case CaseKind::orientedBox:
      return crossOrientedBox(primitive, ray);
    case CaseKind::plane:
      return crossPlane(toVector<N>(primitive.vector(0)), toVector<N>(primitive.vector(3)), ray);
    case CaseKind::triangle:
      return crossTriangle(primitive, ray);
  }
  return std::nullopt;
}

}  // namespace twintrace::exact
