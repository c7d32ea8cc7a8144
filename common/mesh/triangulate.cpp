#include "common/mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace twintrace {
namespace {

/// Twice the area of a triangle, above 0 if it goes round to the left.
double signedArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

glm::dvec3 areaVector(std::span<const glm::vec3> polygon) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 origin(polygon.front());
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += glm::cross(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin);
  }
  return sum * 0.5;
}

Cut PolygonCutter::cut(std::span<const glm::vec3> polygon, std::uint32_t first,
                       std::vector<Corners>& triangles) {
  const glm::dvec3 normal = areaVector(polygon);
  if (normal == glm::dvec3(0.0)) return Cut::nothing;
  if (polygon.size() == 3) {
    triangles.push_back({first, first + 1, first + 2});
    return Cut::clean;
  }
  const std::size_t before = triangles.size();
  project(polygon, normal);
  // One pass finds all ears of a polygon that doesn't cross or touch itself.
  constexpr int kPasses = 2;
  bool done = false;
  for (int pass = 0; pass < kPasses && !done; ++pass) done = cutEars(first, triangles);
  if (!done) cutAnyhow(first, triangles);
  if (triangles.size() == before) return Cut::nothing;
  return done ? Cut::clean : Cut::crossed;
}

/// Along the axis that the normal is nearest to, so that the polygon goes round to the left.
void PolygonCutter::project(std::span<const glm::vec3> polygon, const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = (axis + 1) % 3;
  int v = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(u, v);
  const auto count = static_cast<std::uint32_t>(polygon.size());
  corners_.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    corners_.push_back(
        {{polygon[i][u], polygon[i][v]}, (i + count - 1) % count, (i + 1) % count, true});
  }
  leftCount_ = count;
}

double PolygonCutter::turn(std::uint32_t corner) const {
  const Corner& c = corners_[corner];
  return signedArea(corners_[c.previous].at, c.at, corners_[c.next].at);
}

bool PolygonCutter::isEar(std::uint32_t corner) const {
  if (turn(corner) <= 0.0) return false;
  const glm::dvec2& a = corners_[corners_[corner].previous].at;
  const glm::dvec2& b = corners_[corner].at;
  const glm::dvec2& c = corners_[corners_[corner].next].at;
  return std::ranges::none_of(blockers_, [&](std::uint32_t blocker) {
    const glm::dvec2& p = corners_[blocker].at;
    // Where a polygon with a hole is cut open, corners coincide.
    if (!corners_[blocker].left || p == a || p == b || p == c) return false;
    return signedArea(a, b, p) >= 0.0 && signedArea(b, c, p) >= 0.0 && signedArea(c, a, p) >= 0.0;
  });
}

void PolygonCutter::remove(std::uint32_t corner) {
  Corner& c = corners_[corner];
  corners_[c.previous].next = c.next;
  corners_[c.next].previous = c.previous;
  c.left = false;
  --leftCount_;
}

void PolygonCutter::add(std::uint32_t corner, std::uint32_t first,
                        std::vector<Corners>& triangles) const {
  const Corner& c = corners_[corner];
  triangles.push_back({first + c.previous, first + corner, first + c.next});
}

void PolygonCutter::listBlockers() {
  blockers_.clear();
  candidates_.clear();
  for (auto i = static_cast<std::uint32_t>(corners_.size()); i-- > 0;) {
    if (!corners_[i].left) continue;
    candidates_.push_back(i);
    if (turn(i) <= 0.0) blockers_.push_back(i);
  }
}

/// Whether only a triangle or a line is left.
bool PolygonCutter::cutEars(std::uint32_t first, std::vector<Corners>& triangles) {
  listBlockers();
  while (leftCount_ > 3 && !candidates_.empty()) {
    const std::uint32_t corner = candidates_.back();
    candidates_.pop_back();
    if (!corners_[corner].left || !isEar(corner)) continue;
    add(corner, first, triangles);
    remove(corner);
    candidates_.push_back(corners_[corner].previous);
    candidates_.push_back(corners_[corner].next);
  }
  if (leftCount_ > 3) return false;
  const auto last = std::ranges::find_if(corners_, &Corner::left) - corners_.begin();
  const auto corner = static_cast<std::uint32_t>(last);
  if (turn(corner) > 0.0) add(corner, first, triangles);
  return true;
}

/// Cuts off every corner in turn, with a triangle if it is convex.
void PolygonCutter::cutAnyhow(std::uint32_t first, std::vector<Corners>& triangles) {
  for (std::uint32_t i = 0; i < corners_.size() && leftCount_ > 2; ++i) {
    if (!corners_[i].left) continue;
    if (turn(i) > 0.0) add(i, first, triangles);
    remove(i);
  }
}

}  // namespace twintrace
