#include "cpu/embree_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace twintrace {
namespace {

/// Corner i of a box has its maximum on x, y, z where bit 0, 1, 2 of i is set. Counterclockwise as
/// seen from outside, so that normals point outward.
constexpr std::array<unsigned, 3 * kTrianglesPerBox> kBoxCorners = {
    0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,   // -x, +x
    0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,   // -y, +y
    0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};  // -z, +z

/// Adds the triangles of the last 8 vertices. Axes that are left-handed turn the corners inside out.
void addCorners(EmbreeTriangles& triangles, bool turned) {
  const auto first = static_cast<unsigned>(triangles.vertices.size()) - 8u;
  for (std::size_t i = 0; i < kBoxCorners.size(); i += 3) {
    triangles.indices.emplace_back(first + kBoxCorners[i],
                                   first + kBoxCorners[i + (turned ? 2 : 1)],
                                   first + kBoxCorners[i + (turned ? 1 : 2)]);
  }
}

/// Debian's Embree ends the program on a ray with a component beyond its FLT_LARGE.
bool isInReach(const glm::vec3& v) {
  constexpr float kFarthest = 1.844e18f;
  const glm::vec3 size = glm::abs(v);
  return size.x <= kFarthest && size.y <= kFarthest && size.z <= kFarthest;
}

/// A geometry's buffer of `count` elements, filled from `data`.
template <class T>
void fillBuffer(const EmbreeGeometry& geometry, RTCBufferType type, RTCFormat format,
                const std::vector<T>& data) {
  void* buffer = rtcSetNewGeometryBuffer(geometry.get(), type, 0, format, sizeof(T), data.size());
  if (buffer != nullptr) std::copy(data.begin(), data.end(), static_cast<T*>(buffer));
}

}  // namespace

void EmbreeTriangles::addBox(const glm::vec3& minimum, const glm::vec3& maximum) {
  for (int i = 0; i < 8; ++i) {
    vertices.emplace_back(i & 1 ? maximum.x : minimum.x, i & 2 ? maximum.y : minimum.y,
                          i & 4 ? maximum.z : minimum.z);
  }
  addCorners(*this, false);
}

void EmbreeTriangles::addOrientedBox(const glm::vec3& center, const std::array<glm::vec3, 3>& axes,
                                     const glm::vec3& halfSize) {
  const glm::dmat3 rows{glm::dvec3(axes[0]), glm::dvec3(axes[1]), glm::dvec3(axes[2])};
  const glm::dmat3 toWorld = glm::inverse(glm::transpose(rows));
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 sides(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    vertices.emplace_back(glm::dvec3(center) + toWorld * (sides * glm::dvec3(halfSize)));
  }
  addCorners(*this, glm::determinant(rows) < 0.0);
}

void EmbreeTriangles::addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const auto first = static_cast<unsigned>(vertices.size());
  vertices.insert(vertices.end(), {a, b, c});
  indices.emplace_back(first, first + 1, first + 2);
}

void attachSpheres(const EmbreeDevice& device, const EmbreeScene& scene, unsigned id,
                   const std::vector<glm::vec4>& spheres) {
  if (spheres.empty()) return;
  const EmbreeGeometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT));
  fillBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, spheres);
  attachEmbreeGeometry(scene, geometry, id);
}

void attachTriangles(const EmbreeDevice& device, const EmbreeScene& scene, unsigned id,
                     const EmbreeTriangles& triangles) {
  if (triangles.indices.empty()) return;
  const EmbreeGeometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  fillBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, triangles.vertices);
  fillBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles.indices);
  attachEmbreeGeometry(scene, geometry, id);
}

bool isEmbreeRay(const CastRay& ray) {
  return isInReach(ray.origin) && isInReach(ray.direction) && ray.direction != glm::vec3(0.0f) &&
         ray.tmin <= ray.tmax;
}

RTCRayHit castEmbree(const EmbreeScene& scene, const CastRay& ray) {
  EmbreeContext context = makeEmbreeContext();
  RTCRayHit query = makeEmbreeQuery(ray.origin, ray.direction, std::max(ray.tmin, 0.0f), ray.tmax);
  intersectEmbree(scene, context, query);
  return query;
}

glm::vec3 normalOf(const RTCHit& hit) {
  return glm::vec3(glm::normalize(glm::dvec3(hit.Ng_x, hit.Ng_y, hit.Ng_z)));
}

}  // namespace twintrace
