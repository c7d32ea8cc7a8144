#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "common/cast/case_set.h"

namespace twintrace::test {

using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

/// A number between two rationals, equal ones if it is rational itself.
struct Bracket {
  Rational low;
  Rational high;
};

/// What the oracle says of one primitive.
struct OracleHit {
  Bracket t;
  bool leaving = false;
};

/// Closest hits by rational arithmetic on points of the ray: a second way to what the arbiter
/// decides, sharing nothing with it. Spheres by the signs of |p - c|^2 - r^2 at rational t and by
/// bisection; boxes by asking of each face's plane whether the point there is in the box; triangles
/// by solving for barycentric coordinates.
class RationalOracle {
 public:
  explicit RationalOracle(const CastRay& ray)
      : origin_(vector(ray.origin)),
        direction_(vector(ray.direction)),
        tmin_(ray.tmin),
        tmax_(std::min(ray.tmax, std::numeric_limits<float>::max())) {}

  std::optional<OracleHit> cross(const CasePrimitive& p) const {
    switch (p.kind) {
      case CaseKind::sphere:
        return crossSphere(vector(p.vector(0)), Rational(p.values[3]));
      case CaseKind::box:
        return crossSlabs(boxFaces(p));
      case CaseKind::orientedBox:
        return crossSlabs(orientedBoxFaces(p));
      case CaseKind::plane:
        return crossPlane(vector(p.vector(0)), vector(p.vector(3)));
      case CaseKind::triangle:
        return crossTriangle(vector(p.vector(0)), vector(p.vector(3)), vector(p.vector(6)));
    }
    return std::nullopt;
  }

 private:
  /// low <= axis . p <= high
  struct Faces {
    RationalVector axis;
    Rational low;
    Rational high;
  };

  static RationalVector vector(const glm::vec3& v) {
    return {Rational(v.x), Rational(v.y), Rational(v.z)};
  }
  static Rational product(const RationalVector& a, const RationalVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static RationalVector minus(const RationalVector& a, const RationalVector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  RationalVector at(const Rational& t) const {
    return {origin_[0] + t * direction_[0], origin_[1] + t * direction_[1],
            origin_[2] + t * direction_[2]};
  }
  bool reaches(const Rational& t) const { return tmin_ <= t && t <= tmax_; }

  static std::array<Faces, 3> boxFaces(const CasePrimitive& box) {
    std::array<Faces, 3> faces;
    for (int i = 0; i < 3; ++i) {
      faces[i] = {{0, 0, 0}, Rational(box.values[i]), Rational(box.values[i + 3])};
      faces[i].axis[i] = 1;
    }
    return faces;
  }

  static std::array<Faces, 3> orientedBoxFaces(const CasePrimitive& box) {
    std::array<Faces, 3> faces;
    for (int i = 0; i < 3; ++i) {
      const RationalVector axis = vector(box.vector(3 + 3 * i));
      const Rational middle = product(axis, vector(box.vector(0)));
      const Rational half(box.values[12 + i]);
      faces[i] = {axis, middle - half, middle + half};
    }
    return faces;
  }

  std::optional<OracleHit> crossSlabs(const std::array<Faces, 3>& slabs) const {
    std::vector<Rational> crossings;
    for (const Faces& faces : slabs) {
      const Rational slope = product(faces.axis, direction_);
      if (slope == 0) continue;
      for (const Rational& bound : {faces.low, faces.high}) {
        const Rational t = (bound - product(faces.axis, origin_)) / slope;
        const RationalVector p = at(t);
        const bool within = std::all_of(slabs.begin(), slabs.end(), [&](const Faces& other) {
          const Rational height = product(other.axis, p);
          return other.low <= height && height <= other.high;
        });
        if (within) crossings.push_back(t);
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (const Rational& t : crossings) {
      if (reaches(t)) return OracleHit{{t, t}, t != crossings.front()};
    }
    return std::nullopt;
  }

  std::optional<OracleHit> crossPlane(const RationalVector& normal,
                                      const RationalVector& point) const {
    const Rational slope = product(normal, direction_);
    if (slope == 0) return std::nullopt;
    const Rational t = (product(normal, point) - product(normal, origin_)) / slope;
    if (!reaches(t)) return std::nullopt;
    return OracleHit{{t, t}, false};
  }

  std::optional<OracleHit> crossTriangle(const RationalVector& a, const RationalVector& b,
                                         const RationalVector& c) const {
    const RationalVector u = minus(b, a);
    const RationalVector v = minus(c, a);
    const Rational uu = product(u, u), uv = product(u, v), vv = product(v, v);
    const Rational area = uu * vv - uv * uv;
    if (area == 0) return std::nullopt;
    const RationalVector normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                   u[0] * v[1] - u[1] * v[0]};
    const auto hit = crossPlane(normal, a);
    if (!hit) return std::nullopt;
    const RationalVector w = minus(at(hit->t.low), a);
    const Rational wu = product(w, u), wv = product(w, v);
    const Rational s = (wu * vv - wv * uv) / area;
    const Rational r = (wv * uu - wu * uv) / area;
    if (s < 0 || r < 0 || s + r > 1) return std::nullopt;
    return hit;
  }

  std::optional<OracleHit> crossSphere(const RationalVector& center, const Rational& radius) const {
    const auto outside = [&](const Rational& t) -> Rational {
      const RationalVector f = minus(at(t), center);
      return product(f, f) - radius * radius;
    };
    const Rational middle =
        product(minus(center, origin_), direction_) / product(direction_, direction_);
    if (outside(middle) > 0) return std::nullopt;
    const bool entryReached =
        tmin_ <= middle && outside(tmin_) >= 0 && (tmax_ >= middle || outside(tmax_) <= 0);
    if (entryReached) return OracleHit{bisect(outside, middle, -1), false};
    const bool exitReached =
        (tmin_ <= middle || outside(tmin_) <= 0) && tmax_ >= middle && outside(tmax_) >= 0;
    if (exitReached) return OracleHit{bisect(outside, middle, 1), true};
    return std::nullopt;
  }

  /// The root of `outside` on one side of the middle, to within 2^-80 of its distance from there
  /// and of itself.
  template <class Function>
  static Bracket bisect(const Function& outside, const Rational& middle, int side) {
    if (outside(middle) == 0) return {middle, middle};
    Rational step = 1;
    while (outside(middle + side * step) < 0) step *= 2;
    while (outside(middle + side * step / 2) > 0) step /= 2;
    Rational near = middle;  // inside
    Rational far = middle + side * step;
    for (int i = 0; i < 80 || (i < 400 && wide(near, far)); ++i) {
      Rational half = (near + far) / 2;
      const Rational sign = outside(half);
      if (sign == 0) return {half, half};
      (sign < 0 ? near : far) = std::move(half);
    }
    return {std::min(near, far), std::max(near, far)};
  }

  static bool wide(const Rational& a, const Rational& b) {
    return abs(a - b) * Rational(boost::multiprecision::cpp_int(1) << 80) > abs(a);
  }

  RationalVector origin_;
  RationalVector direction_;
  Rational tmin_;
  Rational tmax_;
};

}  // namespace twintrace::test
