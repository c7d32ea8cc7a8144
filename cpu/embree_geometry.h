#pragma once

// What the two witnesses, of scenes and of cases, share: a scene's shapes as Embree has them.

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "common/trace/ray_caster.h"
#include "cpu/embree_device.h"

namespace twintrace {

inline constexpr int kTrianglesPerBox = 12;

/// Triangles that share one list of vertices.
struct EmbreeTriangles {
  std::vector<glm::vec3> vertices;
  std::vector<glm::uvec3> indices;

  /// Adds kTrianglesPerBox with outward normals.
  void addBox(const glm::vec3& minimum, const glm::vec3& maximum);

  /// Adds the box |axis_i . (p - center)| <= halfSize_i, for axes of any length and angle.
  void addOrientedBox(const glm::vec3& center, const std::array<glm::vec3, 3>& axes,
                      const glm::vec3& halfSize);

  void addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
};

/// Attaches sphere points, given as center and radius; none at all attach nothing.
void attachSpheres(const EmbreeDevice& device, const EmbreeScene& scene, unsigned id,
                   const std::vector<glm::vec4>& spheres);

/// Attaches triangles; none at all attach nothing.
void attachTriangles(const EmbreeDevice& device, const EmbreeScene& scene, unsigned id,
                     const EmbreeTriangles& triangles);

/// What Embree asks of a ray; else its answer is undefined.
bool isEmbreeRay(const CastRay& ray);

/// The ray's closest hit, if any. Embree has no negative t: the interval is cut to t >= 0.
RTCRayHit castEmbree(const EmbreeScene& scene, const CastRay& ray);

/// The unit normal of a hit, outward.
glm::vec3 normalOf(const RTCHit& hit);

}  // namespace twintrace
