#pragma once

// Twin of shaders/hulls/hull_access.glsl: the only reader of hulls.

#include "cpu/kernel/hulls/hull_ray.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

/// What lies in a hull: nodes if `inner`, else references.
struct HullLink {
  int first;
  int count;
  bool inner;
};

inline glm::uvec4 fetchHullTexel(const SceneView& scene, int hullTexel) {
  return scene.hulls.texels[hullTexel];
}

inline HullLink fetchHullLink(const SceneView& scene, int node) {
  const int behind = (node + 1) * scene.hulls.nodeTexels;
  const glm::uvec4 texel = fetchHullTexel(scene, behind - 1);
  return {static_cast<int>(texel.x), static_cast<int>(texel.y), texel.z != 0u};
}

/// The primitive of a reference.
inline int fetchReference(const SceneView& scene, int reference) {
  const int at = scene.hulls.referenceOffset + (reference >> 2);
  const glm::uvec4 texel = fetchHullTexel(scene, at);
  return static_cast<int>(texel[reference & 3]);
}

template <class R>
Vec3<R> hullVector(const glm::uvec4& texel) {
  return {numberFromBits<R>(texel.x), numberFromBits<R>(texel.y), numberFromBits<R>(texel.z)};
}

TWINTRACE_KERNEL_END
