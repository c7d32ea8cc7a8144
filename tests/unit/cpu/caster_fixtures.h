#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "common/scene/flat_scene.h"
#include "common/trace/ray_caster.h"

namespace twintrace::test {

using Shape = decltype(Object::shape);

/// A flat scene of these shapes, all of one grey material.
inline std::shared_ptr<const FlatScene> flatSceneOf(const std::vector<Shape>& shapes) {
  Scene scene;
  scene.materials.emplace_back().albedo = glm::vec3(0.5f);
  for (const Shape& shape : shapes) scene.objects.push_back(Object{"object", shape, 0});
  return std::make_shared<const FlatScene>(flatten(scene, scene.render));
}

inline std::string hexText(const glm::vec3& v) {
  char text[96];
  std::snprintf(text, sizeof text, "(%a, %a, %a)", v.x, v.y, v.z);
  return text;
}

inline std::string hexText(const CastRay& ray) {
  char interval[64];
  std::snprintf(interval, sizeof interval, " [%a, %a]", ray.tmin, ray.tmax);
  return hexText(ray.origin) + " + t " + hexText(ray.direction) + interval;
}

inline std::string hexText(const CastHit& hit) {
  char text[64];
  std::snprintf(text, sizeof text, "primitive %d at %a", hit.primitive, hit.t);
  return text;
}

}  // namespace twintrace::test
