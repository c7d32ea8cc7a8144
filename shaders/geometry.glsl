// All primitives against one ray, and those that were hit, from the texel array. For small scenes a
// generated file with the same functions stands in for this one, with the geometry as literals.
#pragma once

#include "intersect.glsl"
#include "scene_access.glsl"

Sphere visitedSphere(int index) {
  return fetchSphere(index);
}

Box visitedBox(int index) {
  return fetchBox(index);
}

OrientedBox visitedOrientedBox(int index) {
  return fetchOrientedBox(index);
}

Triangle visitedTriangle(int index) {
  return fetchTriangle(index);
}

Plane visitedPlane(int index) {
  return fetchPlane(index);
}

// What has no bounds: the last primitives.
Hit visitPlanes(Ray ray, Hit start) {
  precise Hit best = start;
  int primitive = kSphereCount + kBoxCount + kOrientedBoxCount + kTriangleCount;
  if (kEffectPlane) {
    for (int i = 0; i < kPlaneCount; ++i) {
      best = nearer(best, intersectPlane(ray, fetchPlane(i)), primitive + i);
    }
  }
  return best;
}

Hit visitGeometry(Ray ray, Hit start) {
  precise Hit best = start;
  int primitive = 0;
  if (kEffectSphere) {
    for (int i = 0; i < kSphereCount; ++i) {
      best = nearer(best, intersectSphere(ray, fetchSphere(i)), primitive + i);
    }
  }
  primitive += kSphereCount;
  if (kEffectBox) {
    for (int i = 0; i < kBoxCount; ++i) {
      best = nearer(best, intersectBox(ray, fetchBox(i)), primitive + i);
    }
  }
  primitive += kBoxCount;
  if (kEffectOrientedBox) {
    for (int i = 0; i < kOrientedBoxCount; ++i) {
      best = nearer(best, intersectOrientedBox(ray, fetchOrientedBox(i)), primitive + i);
    }
  }
  primitive += kOrientedBoxCount;
  if (kEffectTriangle) {
    for (int i = 0; i < kTriangleCount; ++i) {
      best = nearer(best, intersectTriangle(ray, fetchTriangle(i)), primitive + i);
    }
  }
  precise Hit result = visitPlanes(ray, best);
  return result;
}
