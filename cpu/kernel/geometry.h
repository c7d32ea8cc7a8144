#pragma once

// Twin of shaders/geometry.glsl: all primitives against one ray, and those that were hit.

#include "cpu/kernel/intersect.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
Sphere<R> visitedSphere(const SceneView& scene, IntOf<R> index) {
  return fetchSphere<R>(scene, index);
}

template <class R>
Box<R> visitedBox(const SceneView& scene, IntOf<R> index) {
  return fetchBox<R>(scene, index);
}

template <class R>
OrientedBox<R> visitedOrientedBox(const SceneView& scene, IntOf<R> index) {
  return fetchOrientedBox<R>(scene, index);
}

template <class R>
Triangle<R> visitedTriangle(const SceneView& scene, IntOf<R> index) {
  return fetchTriangle<R>(scene, index);
}

template <class R>
Plane<R> visitedPlane(const SceneView& scene, IntOf<R> index) {
  return fetchPlane<R>(scene, index);
}

/// What has no bounds: the last primitives.
template <class R>
Hit<R> visitPlanes(const SceneView& scene, const Ray<R>& ray, const Hit<R>& start) {
  Hit<R> best = start;
  if (scene.effectPlane) {
    for (int i = 0; i < scene.index.planeCount; ++i) {
      const R t = intersectPlane(scene, ray, fetchPlane<R>(scene, i));
      best = nearer(best, t, IntOf<R>(scene.index.boundedCount() + i));
    }
  }
  return best;
}

template <class R>
Hit<R> visitGeometry(const SceneView& scene, const Ray<R>& ray, const Hit<R>& start) {
  using Int = IntOf<R>;
  Hit<R> best = start;
  int primitive = 0;
  if (scene.effectSphere) {
    for (int i = 0; i < scene.index.sphereCount; ++i) {
      const R t = intersectSphere(scene, ray, fetchSphere<R>(scene, i));
      best = nearer(best, t, Int(primitive + i));
    }
  }
  primitive += scene.index.sphereCount;
  if (scene.effectBox) {
    for (int i = 0; i < scene.index.boxCount; ++i) {
      const R t = intersectBox(scene, ray, fetchBox<R>(scene, i));
      best = nearer(best, t, Int(primitive + i));
    }
  }
  primitive += scene.index.boxCount;
  if (scene.effectOrientedBox) {
    for (int i = 0; i < scene.index.orientedBoxCount; ++i) {
      const R t = intersectOrientedBox(scene, ray, fetchOrientedBox<R>(scene, i));
      best = nearer(best, t, Int(primitive + i));
    }
  }
  primitive += scene.index.orientedBoxCount;
  if (scene.effectTriangle) {
    for (int i = 0; i < scene.index.triangleCount; ++i) {
      const R t = intersectTriangle(scene, ray, fetchTriangle<R>(scene, i));
      best = nearer(best, t, Int(primitive + i));
    }
  }
  return visitPlanes(scene, ray, best);
}

TWINTRACE_KERNEL_END
