#pragma once

// Judges the hits of float engines by intervals in double: each primitive's surface may be anywhere
// within a stated bound of where it is, and a hit is justified if it can be had that way.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "common/trace/ray_caster.h"
#include "cpu/kernel/scene_access.h"

namespace twintrace::test {

/// How far an engine's surface may be from the true one, in units of the largest distance D from a
/// ray's origin to a point of the primitive (for oriented boxes, whose corners an engine may round,
/// plus the centre's coordinates): 32 u = 16 ulp, u = 2^-24. To first order in u:
/// - Kernel, slabs: 3 u D for a plane, 12 u D for the widening, 8 u D for an oriented box's ray.
/// - Kernel, sphere of radius r, x = |origin - centre| / r, D = (1 + x) r: 12 u D across the ray;
///   along it the root c / q is off by e / q, |e| <= (4 x^2 + 20 x) u r^2. For x >= 2 that is 17 u
///   D. For 1 <= x < 2 the half chord is at most q / 2, hence the point's height is off by at most
///   e / 2r <= (2 x^2 + 10 x) u r; for x < 1 by e / r <= 24 u r. The second order term (e/q)^2 / 2r
///   stays below 24 u r unless the origin is within 6 u r of the surface and the ray within
///   4 sqrt(u) of its tangent.
/// - Embree: its sphere points take t as projection -+ half chord, 12 u D and 5 u D; its triangles
///   test edges by Pluecker coordinates, 8 u D, and take t from the plane, 8 u D.
/// - Kernel, triangle: corners relative to the origin, 1 u D, and beside the ray, 2 u D more; the rest in
///   double.
inline constexpr double kSurfaceBound = 32.0 / (1 << 24);

/// Distances between which a line is inside a primitive; empty is a miss.
struct Chord {
  double enter = std::numeric_limits<double>::infinity();
  double leave = -std::numeric_limits<double>::infinity();
  bool empty() const { return enter > leave; }
};

struct Line {
  glm::dvec3 origin;
  glm::dvec3 direction;
};

inline glm::dvec3 toDouble(const kernel::Vec3<float>& v) {
  return {v.x, v.y, v.z};
}

inline Chord sphereChord(const Line& line, double radius) {
  if (radius <= 0.0) return {};
  const glm::dvec3& d = line.direction;
  const double a = glm::dot(d, d);
  const double middle = -glm::dot(line.origin, d) / a;
  const glm::dvec3 toAxis = line.origin + d * middle;
  const double squared = radius * radius - glm::dot(toAxis, toAxis);
  if (squared < 0.0) return {};
  const double half = std::sqrt(squared / a);
  return {middle - half, middle + half};
}

inline Chord boxChord(const Line& line, const glm::dvec3& half) {
  Chord chord{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    const double o = line.origin[axis];
    const double d = line.direction[axis];
    if (half[axis] <= 0.0 || (d == 0.0 && std::fabs(o) > half[axis])) return {};
    if (d == 0.0) continue;
    const double a = (-half[axis] - o) / d;
    const double b = (half[axis] - o) / d;
    chord = {std::max(chord.enter, std::min(a, b)), std::min(chord.leave, std::max(a, b))};
  }
  return chord.empty() ? Chord{} : chord;
}

/// A triangle seen from a ray's origin.
struct LocalTriangle {
  std::array<glm::dvec3, 3> corners;

  glm::dvec3 normal() const {
    return glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  }
  /// The distances at which a ray is within `bound` of the plane and, beside the edges, no further
  /// outside than `reach`.
  Chord chord(const glm::dvec3& direction, double bound, double reach) const {
    Chord chord{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const glm::dvec3 n = normal();
    const auto limit = [&](const glm::dvec3& outward, const glm::dvec3& at, double most) {
      const double speed = glm::dot(outward, direction);
      const double room = most + glm::dot(outward, at);
      if (speed > 0.0) chord.leave = std::min(chord.leave, room / speed);
      if (speed < 0.0) chord.enter = std::max(chord.enter, room / speed);
      if (speed == 0.0 && room < 0.0) chord = {};
    };
    limit(n, corners[0], bound);
    limit(-n, corners[0], bound);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 edge = corners[(i + 1) % 3] - corners[i];
      limit(glm::normalize(glm::cross(edge, n)), corners[i], reach);
    }
    return chord.empty() ? Chord{} : chord;
  }
  double largest() const {
    return std::max({glm::length(corners[0]), glm::length(corners[1]), glm::length(corners[2])});
  }
};

/// A primitive seen from one ray: a sphere or a box about the origin of its own frame.
struct LocalPrimitive {
  Line line;
  bool isSphere = false;
  glm::dvec3 half{0.0};  ///< radius in all components, or half size
  double bound = 0.0;    ///< of the surface's place

  Chord chord(double grown) const {
    return isSphere ? sphereChord(line, half.x + grown) : boxChord(line, half + grown);
  }
  /// Distance of a ray's point from the surface, in units of the bound.
  double residual(double t) const {
    const glm::dvec3 p = line.origin + line.direction * t;
    const glm::dvec3 outside = glm::abs(p) - half;
    const double height =
        isSphere ? glm::length(p) - half.x : std::max({outside.x, outside.y, outside.z});
    return std::fabs(height) / bound;
  }
};

inline LocalPrimitive localPrimitive(const kernel::SceneView& scene, const CastRay& ray,
                                     int primitive) {
  const glm::dvec3 origin(ray.origin);
  const glm::dvec3 direction(ray.direction);
  LocalPrimitive result;
  double rounded = 0.0;
  const int box = primitive - scene.index.sphereCount;
  const int orientedBox = box - scene.index.boxCount;
  if (box < 0) {
    const auto sphere = kernel::fetchSphere<float>(scene, primitive);
    const glm::dvec3 radius(std::fabs(double(sphere.radius)));
    result = {{origin - toDouble(sphere.center), direction}, true, radius};
  } else if (orientedBox < 0) {
    const auto bounds = kernel::fetchBox<float>(scene, box);
    const glm::dvec3 low = toDouble(bounds.minimum);
    const glm::dvec3 high = toDouble(bounds.maximum);
    result = {{origin - (low + high) * 0.5, direction}, false, (high - low) * 0.5};
  } else {
    const auto turned = kernel::fetchOrientedBox<float>(scene, orientedBox);
    const glm::dvec3 axes[] = {toDouble(turned.axisX), toDouble(turned.axisY),
                               toDouble(turned.axisZ)};
    const glm::dvec3 from = origin - toDouble(turned.center);
    const auto local = [&](const glm::dvec3& v) {
      return glm::dvec3(glm::dot(axes[0], v), glm::dot(axes[1], v), glm::dot(axes[2], v));
    };
    result = {{local(from), local(direction)}, false, toDouble(turned.halfSize)};
    rounded = glm::length(toDouble(turned.center));
  }
  const double distance = glm::length(result.line.origin) + glm::length(result.half) + rounded;
  result.bound = kSurfaceBound * distance;
  return result;
}

/// What one ray can see of one primitive.
struct Sight {
  Chord grown;
  Chord shrunk;  ///< empty for a ray that may miss
  bool solid = true;  ///< a ray that begins inside must leave
  bool silhouette() const { return shrunk.empty(); }

  bool isEntry(double t) const { return t >= grown.enter && t <= shrunk.enter; }
  bool isExit(double t) const { return t >= shrunk.leave && t <= grown.leave; }
  bool allows(double t) const {
    if (silhouette()) return t >= grown.enter && t <= grown.leave;
    return isEntry(t) || isExit(t);
  }
  bool sameSide(double a, double b) const {
    return !silhouette() && ((isEntry(a) && isEntry(b)) || (isExit(a) && isExit(b)));
  }
  /// Whether the ray begins where the surface may be.
  bool startsOnSurface(const CastRay& ray) const { return allows(ray.tmin); }
  /// The latest distance at which the primitive must have been hit; infinity if it need not be.
  double latest(const CastRay& ray) const {
    double t = std::numeric_limits<double>::infinity();
    if (silhouette()) return t;
    if (grown.enter >= ray.tmin) {
      t = shrunk.enter;
    } else if (solid && shrunk.leave >= ray.tmin) {
      t = grown.leave;
    }
    return t <= ray.tmax ? t : std::numeric_limits<double>::infinity();
  }
};

inline LocalTriangle localTriangle(const kernel::SceneView& scene, const CastRay& ray,
                                   int triangle) {
  const auto record = kernel::fetchTriangle<float>(scene, triangle);
  const glm::dvec3 origin(ray.origin);
  return {{toDouble(record.a) - origin, toDouble(record.b) - origin, toDouble(record.c) - origin}};
}

/// A triangle has no inside: within the bound of its plane it may be hit anywhere, and must be if all that
/// way lies inside its edges.
inline Sight sightOf(const LocalTriangle& triangle, const glm::dvec3& direction) {
  const double bound = kSurfaceBound * triangle.largest();
  const Chord grown = triangle.chord(direction, bound, bound);
  const Chord within = triangle.chord(direction, bound, -bound);
  const bool sure = !grown.empty() && within.enter <= grown.enter && within.leave >= grown.leave;
  return {grown, sure ? Chord{grown.leave, grown.leave} : Chord{}, false};
}

/// The first triangle's number.
inline int firstTriangle(const kernel::SceneView& scene) {
  return scene.index.boundedCount() - scene.index.triangleCount;
}

/// How far a hit is from its surface, in units of the bound.
inline double residualOf(const kernel::SceneView& scene, const CastRay& ray, const CastHit& hit) {
  const int triangle = hit.primitive - firstTriangle(scene);
  if (triangle < 0) return localPrimitive(scene, ray, hit.primitive).residual(hit.t);
  const LocalTriangle local = localTriangle(scene, ray, triangle);
  const glm::dvec3 p = glm::dvec3(ray.direction) * double(hit.t);
  return std::fabs(glm::dot(local.normal(), p - local.corners[0])) /
         (kSurfaceBound * local.largest());
}

inline Sight sightOf(const kernel::SceneView& scene, const CastRay& ray, int primitive) {
  const int triangle = primitive - firstTriangle(scene);
  if (triangle >= 0) {
    return sightOf(localTriangle(scene, ray, triangle), glm::dvec3(ray.direction));
  }
  const LocalPrimitive local = localPrimitive(scene, ray, primitive);
  return {local.chord(local.bound), local.chord(-local.bound)};
}

/// How two engines' hits of one ray relate.
enum class Relation {
  equal,            ///< same primitive, same bits of t, or both miss
  sameSurface,      ///< same primitive and side, t within what the bound allows
  nearTie,          ///< two primitives that both can be first
  silhouette,       ///< the ray passes an edge or the tangent within the bound
  startsOnSurface,  ///< the ray begins within the bound of a surface that one engine hits
  unexplained,
};
inline constexpr int kRelationCount = 6;

/// Judges the hits of one ray against all of a scene's primitives with bounds.
class HitJudge {
 public:
  HitJudge(const kernel::SceneView& scene, const CastRay& ray) : scene_(scene), ray_(ray) {}

  /// Whether a hit, or a miss, can be had within the bound.
  bool justified(const CastHit& hit) const {
    const double latest = latestHit();
    if (!hit.valid()) return std::isinf(latest);
    return hit.t >= ray_.tmin && hit.t <= ray_.tmax && hit.t <= latest && sight(hit).allows(hit.t);
  }

  Relation relate(const CastHit& a, const CastHit& b) const {
    if (a.primitive == b.primitive && (!a.valid() || a.t == b.t)) return Relation::equal;
    if (!justified(a) || !justified(b)) return Relation::unexplained;
    if (a.primitive == b.primitive && sight(a).sameSide(a.t, b.t)) return Relation::sameSurface;
    if (involves(a, b, [&](const Sight& s) { return s.startsOnSurface(ray_); })) {
      return Relation::startsOnSurface;
    }
    if (involves(a, b, [](const Sight& s) { return s.silhouette(); })) return Relation::silhouette;
    return Relation::nearTie;
  }

 private:
  /// Where something must have been hit; infinity if nothing need be.
  double latestHit() const {
    double latest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < scene_.index.boundedCount(); ++i) {
      latest = std::min(latest, sightOf(scene_, ray_, i).latest(ray_));
    }
    return latest;
  }

  Sight sight(const CastHit& hit) const { return sightOf(scene_, ray_, hit.primitive); }

  template <class Property>
  bool involves(const CastHit& a, const CastHit& b, const Property& property) const {
    return (a.valid() && property(sight(a))) || (b.valid() && property(sight(b)));
  }

  const kernel::SceneView& scene_;
  const CastRay& ray_;
};

}  // namespace twintrace::test
