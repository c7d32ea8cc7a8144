#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "common/generate/parts.h"
#include "common/hulls/hull_caster.h"
#include "common/hulls/hull_structure.h"
#include "common/mesh/mesh.h"
#include "common/scene/flat_scene.h"

namespace twintrace::test {

class HullRandom {
 public:
  explicit HullRandom(unsigned seed) : engine_(seed) {}

  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  glm::vec3 inCube(float half) {
    return {uniform(-half, half), uniform(-half, half), uniform(-half, half)};
  }
  glm::vec3 direction() {
    while (true) {
      const glm::vec3 v = inCube(1.0f);
      const float squared = glm::dot(v, v);
      if (squared > 1e-4f && squared <= 1.0f) return v / std::sqrt(squared);
    }
  }

 private:
  std::mt19937 engine_;
};

inline void addObject(Scene& scene, decltype(Object::shape) shape) {
  scene.objects.push_back({"object" + std::to_string(scene.objects.size()), std::move(shape), 0});
}

inline void addMesh(Scene& scene, Mesh mesh) {
  Parts parts;
  parts.mesh = std::move(mesh);
  MeshShape shape;
  shape.smooth = false;
  shape.parts = std::make_shared<const Parts>(std::move(parts));
  addObject(scene, std::move(shape));
}

/// Random triangles of about the given size about a point; every fifth lies in an axis' plane.
inline Mesh triangleCloud(HullRandom& random, const glm::vec3& center, float spread, float size,
                          int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 at = center + random.inCube(spread);
    for (int corner = 0; corner < 3; ++corner) {
      glm::vec3 offset = random.inCube(size);
      if (i % 5 == 0) offset[i % 3] = 0.0f;
      mesh.positions.push_back(at + offset);
    }
    const auto first = static_cast<std::uint32_t>(3 * i);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// Everything that has bounds, and a plane, about a point; coordinates of about `size`.
inline Scene mixedScene(unsigned seed, const glm::vec3& center, float size) {
  HullRandom random(seed);
  Scene scene;
  scene.materials.emplace_back().albedo = glm::vec3(0.5f);
  for (int i = 0; i < 12; ++i) {
    const glm::vec3 at = center + random.inCube(size);
    addObject(scene, SphereShape{at, size * random.uniform(0.02f, 0.3f)});
  }
  for (int i = 0; i < 8; ++i) {
    BoxShape box;
    box.center = center + random.inCube(size);
    box.size = size * (glm::vec3(0.35f) + random.inCube(0.3f));
    if (i % 4 == 3) box.size.y = 0.0f;
    if (i % 2 == 1) box.rotation = random.inCube(180.0f);
    addObject(scene, box);
  }
  addMesh(scene, triangleCloud(random, center, size, 0.3f * size, 60));
  addObject(scene, PlaneShape{center - glm::vec3(0.0f, 1.2f * size, 0.0f), {0.0f, 1.0f, 0.0f}});
  return scene;
}

/// Rays from outside and inside, along axes with zeros of either sign, and from what others hit.
inline std::vector<CastRay> mixedRays(unsigned seed, const glm::vec3& center, float size, int count) {
  HullRandom random(seed);
  std::vector<CastRay> rays;
  for (int i = 0; i < count; ++i) {
    glm::vec3 d = random.direction();
    if (i % 4 == 1) d[random.below(3)] = random.below(2) == 0 ? 0.0f : -0.0f;
    if (i % 8 == 3) {
      const int axis = random.below(3);
      for (int k = 0; k < 3; ++k) d[k] = k == axis ? (random.below(2) == 0 ? 1.0f : -1.0f) : -0.0f;
    }
    if (d == glm::vec3(0.0f)) d = {1.0f, 0.0f, 0.0f};
    const float away = i % 3 == 0 ? 6.0f * size : 0.0f;
    const glm::vec3 target = center + random.inCube(size);
    const glm::vec3 unit = glm::normalize(d);
    CastRay ray{target - unit * away, unit};
    if (i % 7 == 0) ray.tmax = random.uniform(0.0f, 3.0f * size);
    rays.push_back(ray);
  }
  return rays;
}

/// Rays that pass corners and edges of a mesh's triangles as closely as floats can be aimed, and others that
/// graze balls of about that size, from near and from far away.
inline std::vector<CastRay> grazingRays(unsigned seed, const Mesh& mesh, const glm::vec3& ball,
                                        float radius, int count) {
  HullRandom random(seed);
  std::vector<CastRay> rays;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(random.direction()));
    glm::dvec3 target;
    if (i % 4 == 0) {
      const glm::dvec3 aside = glm::normalize(glm::cross(d, glm::dvec3(random.direction())));
      target = glm::dvec3(ball) + aside * double(radius);
    } else {
      const auto& t = mesh.triangles[static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangles.size())))];
      const double along = i % 4 == 1 ? 0.0 : random.uniform(0.0f, 1.0f);
      const glm::dvec3 a(mesh.positions[t[static_cast<std::size_t>(i % 3)]]);
      const glm::dvec3 b(mesh.positions[t[static_cast<std::size_t>((i + 1) % 3)]]);
      target = a + (b - a) * along;
    }
    const double away = radius * std::pow(10.0, random.uniform(-1.0f, 5.0f));
    CastRay ray{glm::vec3(target - d * away), glm::vec3(d)};
    if (i % 5 == 0) {  // an interval that begins before the origin
      ray.origin = glm::vec3(target + d * away);
      ray.tmin = -std::numeric_limits<float>::max();
    }
    rays.push_back(ray);
  }
  return rays;
}

inline std::shared_ptr<const FlatScene> flatWith(const Scene& scene, const std::string& hull,
                                                 RenderOptions options = {}) {
  options.hull = hull;
  return std::make_shared<const FlatScene>(flatten(scene, options));
}

}  // namespace twintrace::test
