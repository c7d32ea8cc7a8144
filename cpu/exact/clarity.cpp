#include "cpu/exact/clarity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace twintrace::exact {
namespace {

constexpr double kUlp = 0x1p-23;
constexpr double kMoves = 8.0;  // ulp, facts of the field: float algorithms err by a few
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A ray with a unit direction; distances along it are scene units.
struct Line {
  explicit Line(const CastRay& ray)
      : origin(ray.origin),
        length(glm::length(glm::dvec3(ray.direction))),
        direction(glm::dvec3(ray.direction) / length),
        nearest(ray.tmin * length),
        farthest(std::min(ray.tmax, std::numeric_limits<float>::max()) * length) {}

  glm::dvec3 origin;
  double length;
  glm::dvec3 direction;
  double nearest;
  double farthest;
};

double largest(const glm::dvec3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

glm::dvec3 axisOf(const CasePrimitive& box, int index) {
  return box.vector(3 + 3 * index);
}

/// Farthest that a corner of an oriented box lies from its centre in a coordinate, or more.
double extent(const CasePrimitive& box) {
  glm::dvec3 sum(0.0);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 axis = axisOf(box, i);
    const double square = glm::dot(axis, axis);
    if (square > 0.0) sum += glm::abs(axis) * (box.values[12 + i] / square);
  }
  return largest(sum);
}

/// Largest coordinate of a primitive.
double reachOf(const CasePrimitive& p) {
  switch (p.kind) {
    case CaseKind::sphere:
      return largest(p.vector(0)) + p.values[3];
    case CaseKind::box:
      return std::max(largest(p.vector(0)), largest(p.vector(3)));
    case CaseKind::orientedBox:
      return largest(p.vector(0)) + extent(p);
    case CaseKind::plane:
      return largest(p.vector(3));
    case CaseKind::triangle:
      return std::max({largest(p.vector(0)), largest(p.vector(3)), largest(p.vector(6))});
  }
  return 0.0;
}

/// ulp(M) for what happens at a distance along the ray.
double ulpAt(const CasePrimitive& primitive, const Line& line, double distance) {
  return kUlp * std::max({reachOf(primitive), largest(line.origin),
                          std::fabs(distance) * largest(line.direction)});
}

/// Distances between which a surface is crossed, however it moves.
struct Range {
  double low = -kInfinity;
  double high = kInfinity;
};

/// What may become of one primitive.
struct Passage {
  bool possible = false;  ///< some move makes the ray cross it
  bool certain = false;   ///< it does after every move
  Range entry;
  Range exit;  ///< as entry for what has no inside
};

double halfChord(double radius, double distance) {
  if (radius <= distance) return 0.0;
  return std::sqrt(radius - distance) * std::sqrt(radius + distance);
}

/// Of a sphere: where the ray comes closest to its centre, and how close.
struct Approach {
  double along;
  double across;
};

Approach approach(const CasePrimitive& sphere, const Line& line) {
  const glm::dvec3 f = glm::dvec3(sphere.vector(0)) - line.origin;
  return {glm::dot(f, line.direction), glm::length(glm::cross(f, line.direction))};
}

Passage passSphere(const CasePrimitive& sphere, const Line& line) {
  const double radius = sphere.values[3];
  const auto [along, across] = approach(sphere, line);
  const double chord = halfChord(radius, across);
  const bool inside = along - chord < line.nearest;
  const double move = kMoves * ulpAt(sphere, line, inside ? along + chord : along - chord);
  const double grown = halfChord(radius + move, across);
  const double shrunk = halfChord(radius - move, across);
  return {across <= radius + move,
          across < radius - move,
          {along - grown, along - shrunk},
          {along + shrunk, along + grown}};
}

/// A slab low <= position + s slope <= high along a line, whose bounds move by up to `move`.
struct MovingSlab {
  double low;
  double high;
  double position;
  double slope;
  double moveScale = 1.0;  ///< change of a bound per scene unit: length of the axis

  Range lowerBound(double move) const { return crossed(low, move); }
  Range upperBound(double move) const { return crossed(high, move); }

 private:
  Range crossed(double bound, double move) const {
    const double a = (bound - move * moveScale - position) / slope;
    const double b = (bound + move * moveScale - position) / slope;
    return {std::min(a, b), std::max(a, b)};
  }
};

using MovingSlabs = std::array<MovingSlab, 3>;

MovingSlabs slabsOf(const CasePrimitive& box, const Line& line) {
  MovingSlabs slabs;
  for (int i = 0; i < 3; ++i) {
    if (box.kind == CaseKind::box) {
      slabs[i] = {box.values[i], box.values[i + 3], line.origin[i], line.direction[i]};
      continue;
    }
    const glm::dvec3 axis = axisOf(box, i);
    const double half = box.values[12 + i];
    slabs[i] = {-half, half, glm::dot(axis, line.origin - glm::dvec3(box.vector(0))),
                glm::dot(axis, line.direction), glm::length(axis)};
  }
  return slabs;
}

/// The passage through slabs. Near and far bound of one slab keep their order, so only bounds of
/// different slabs can make the ray miss.
Passage passSlabs(const MovingSlabs& slabs, double move) {
  Passage passage{true, true, {}, {kInfinity, kInfinity}};
  std::array<Range, 3> near;
  std::array<Range, 3> far;
  for (int i = 0; i < 3; ++i) {
    const MovingSlab& slab = slabs[i];
    if (slab.slope == 0.0) {
      const double shift = move * slab.moveScale;
      const double space = std::min(slab.position - slab.low, slab.high - slab.position);
      passage.possible = passage.possible && space >= -shift;
      passage.certain = passage.certain && (slab.moveScale == 0.0 || space > shift);
      near[i] = {-kInfinity, -kInfinity};
      far[i] = {kInfinity, kInfinity};
      continue;
    }
    near[i] = slab.slope > 0.0 ? slab.lowerBound(move) : slab.upperBound(move);
    far[i] = slab.slope > 0.0 ? slab.upperBound(move) : slab.lowerBound(move);
  }
  passage.entry = {std::max({near[0].low, near[1].low, near[2].low}),
                   std::max({near[0].high, near[1].high, near[2].high})};
  passage.exit = {std::min({far[0].low, far[1].low, far[2].low}),
                  std::min({far[0].high, far[1].high, far[2].high})};
  if (passage.entry.low > passage.exit.high) passage.possible = false;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i != j && !(near[i].high < far[j].low)) passage.certain = false;
    }
  }
  const bool bounded = passage.entry.high > -kInfinity;
  passage.possible = passage.possible && bounded;
  passage.certain = passage.certain && passage.possible;
  return passage;
}

Passage passBox(const CasePrimitive& box, const Line& line) {
  const MovingSlabs slabs = slabsOf(box, line);
  const Passage still = passSlabs(slabs, 0.0);
  double distance = 0.0;
  if (still.possible) {
    distance = still.entry.low < line.nearest ? still.exit.high : still.entry.low;
  }
  return passSlabs(slabs, kMoves * ulpAt(box, line, distance));
}

Passage passPlane(const CasePrimitive& plane, const Line& line) {
  const glm::dvec3 normal = glm::dvec3(plane.vector(0));
  const double length = glm::length(normal);
  if (length == 0.0) return {};
  const double slope = glm::dot(normal, line.direction) / length;
  const double height = glm::dot(normal, glm::dvec3(plane.vector(3)) - line.origin) / length;
  const double turn = kMoves * kUlp;
  const double move = kMoves * ulpAt(plane, line, std::fabs(slope) > turn ? height / slope : 0.0);
  if (std::fabs(slope) > turn) {
    const double a = (height - move) / slope;
    const double b = (height + move) / slope;
    const Range range{std::min(a, b), std::max(a, b)};
    return {true, true, range, range};
  }
  const double closest = (std::fabs(height) - move) / (std::fabs(slope) + turn);
  const bool ahead = line.nearest >= 0.0 && closest > 0.0;
  const Range range{ahead ? closest : -kInfinity, kInfinity};
  return {true, false, range, range};
}

/// Distance of the point 0 from a segment.
double distanceToSegment(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 edge = b - a;
  const double square = glm::dot(edge, edge);
  const double s = square > 0.0 ? std::clamp(-glm::dot(a, edge) / square, 0.0, 1.0) : 0.0;
  return glm::length(a + edge * s);
}

Passage passTriangle(const CasePrimitive& triangle, const Line& line) {
  std::array<glm::dvec3, 3> across;  // vertices as the ray sees them, itself at 0
  Range depth{kInfinity, -kInfinity};
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 w = glm::dvec3(triangle.vector(3 * i)) - line.origin;
    const double along = glm::dot(w, line.direction);
    across[i] = w - line.direction * along;
    depth = {std::min(depth.low, along), std::max(depth.high, along)};
  }
  const double move = kMoves * ulpAt(triangle, line, 0.0);
  double rim = kInfinity;
  std::array<double, 3> sides;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& a = across[i];
    const glm::dvec3& b = across[(i + 1) % 3];
    rim = std::min(rim, distanceToSegment(a, b));
    sides[i] = glm::dot(glm::cross(a, b), line.direction);
  }
  const bool inside = (sides[0] > 0.0 && sides[1] > 0.0 && sides[2] > 0.0) ||
                      (sides[0] < 0.0 && sides[1] < 0.0 && sides[2] < 0.0);
  const bool near = rim <= move;
  Range range{depth.low - move, depth.high + move};
  if (inside && !near) {
    const glm::dvec3 v0 = triangle.vector(0);
    const glm::dvec3 normal = glm::normalize(
        glm::cross(glm::dvec3(triangle.vector(3)) - v0, glm::dvec3(triangle.vector(6)) - v0));
    const double slope = glm::dot(normal, line.direction);
    const double distance = glm::dot(normal, v0 - line.origin) / slope;
    const double shift = kMoves * ulpAt(triangle, line, distance) / std::fabs(slope);
    range = {std::max(range.low, distance - shift), std::min(range.high, distance + shift)};
  }
  return {inside || near, inside && !near, range, range};
}

Passage passageOf(const CasePrimitive& primitive, const Line& line) {
  switch (primitive.kind) {
    case CaseKind::sphere:
      return passSphere(primitive, line);
    case CaseKind::box:
    case CaseKind::orientedBox:
      return passBox(primitive, line);
    case CaseKind::plane:
      return passPlane(primitive, line);
    case CaseKind::triangle:
      return passTriangle(primitive, line);
  }
  return {};
}

bool surelyWithin(const Range& range, const Line& line) {
  return range.low >= line.nearest && range.high <= line.farthest;
}

bool surelyOutside(const Range& range, const Line& line) {
  return range.high < line.nearest || range.low > line.farthest;
}

bool standsAsHit(const Passage& passage, const Line& line, bool leaving) {
  if (!passage.certain || (leaving && passage.entry.high >= line.nearest)) return false;
  return surelyWithin(leaving ? passage.exit : passage.entry, line);
}

/// @param before only what is crossed before this distance counts
bool staysAway(const Passage& passage, const Line& line, double before) {
  const auto away = [&](const Range& range) {
    return surelyOutside(range, line) || range.low > before;
  };
  return !passage.possible || (away(passage.entry) && away(passage.exit));
}

}  // namespace

Clarity clarityOf(std::span<const CasePrimitive> primitives, const CastRay& ray,
                  const ExactHit& hit) {
  const Line line(ray);
  double before = kInfinity;
  if (hit.primitive >= 0) {
    const Passage passage = passageOf(primitives[hit.primitive], line);
    if (!standsAsHit(passage, line, hit.leaving)) return Clarity::ambiguous;
    before = hit.leaving ? passage.exit.high : passage.entry.high;
  }
  for (int i = 0; i < static_cast<int>(primitives.size()); ++i) {
    if (i == hit.primitive) continue;
    if (!staysAway(passageOf(primitives[i], line), line, before)) return Clarity::ambiguous;
  }
  return Clarity::clean;
}

glm::dvec3 normalOf(const CasePrimitive& primitive, const CastRay& ray, const ExactHit& hit,
                    int axis, int side) {
  const Line line(ray);
  glm::dvec3 normal(0.0);
  switch (primitive.kind) {
    case CaseKind::sphere: {
      const glm::dvec3 f = glm::dvec3(primitive.vector(0)) - line.origin;
      const auto [along, across] = approach(primitive, line);
      const double chord = halfChord(primitive.values[3], across);
      normal = line.direction * along - f + line.direction * (hit.leaving ? chord : -chord);
      break;
    }
    case CaseKind::box:
      normal[axis] = side;
      break;
    case CaseKind::orientedBox:
      normal = axisOf(primitive, axis) * double(side);
      break;
    case CaseKind::plane:
      normal = primitive.vector(0);
      break;
    case CaseKind::triangle: {
      const glm::dvec3 v0 = primitive.vector(0);
      normal =
          glm::cross(glm::dvec3(primitive.vector(3)) - v0, glm::dvec3(primitive.vector(6)) - v0);
      break;
    }
  }
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : -line.direction;
}

std::vector<FaceBeside> facesBeside(const CasePrimitive& primitive, const CastRay& ray,
                                    const ExactHit& hit, int axis) {
  std::vector<FaceBeside> faces;
  if (primitive.kind != CaseKind::box && primitive.kind != CaseKind::orientedBox) return faces;
  const Line line(ray);
  const double ulp = ulpAt(primitive, line, hit.t * line.length);
  const MovingSlabs slabs = slabsOf(primitive, line);
  for (int i = 0; i < 3; ++i) {
    const MovingSlab& slab = slabs[i];
    if (i == axis || slab.slope == 0.0) continue;
    const int side = (slab.slope > 0.0) == hit.leaving ? 1 : -1;
    const double bound = side > 0 ? slab.high : slab.low;
    FaceBeside face;
    face.t = (bound - slab.position) / slab.slope / line.length;
    face.tUnit = ulp * slab.moveScale / std::fabs(slab.slope) / line.length;
    if (std::fabs(face.t - hit.t) > kMoves * (face.tUnit + hit.tUnit)) continue;
    face.normal = normalOf(primitive, ray, hit, i, side);
    faces.push_back(face);
  }
  return faces;
}

double tUnitOf(const CasePrimitive& primitive, const CastRay& ray, const ExactHit& hit) {
  const Line line(ray);
  const double ulp = ulpAt(primitive, line, hit.t * line.length);
  if (primitive.kind != CaseKind::sphere) {
    return ulp / std::fabs(glm::dot(hit.normal, line.direction)) / line.length;
  }
  const double radius = primitive.values[3];
  const double across = approach(primitive, line).across;
  const double chord = halfChord(radius, across);
  return std::max(halfChord(radius + ulp, across) - chord,
                  chord - halfChord(radius - ulp, across)) /
         line.length;
}

}  // namespace twintrace::exact
