#pragma once

// Twin of shaders/hit_surface.glsl: the surface at a hit, whatever its primitive is.

#include "cpu/kernel/surface.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
Surface<R> chosenSurface(MaskOf<R> condition, const Surface<R>& a, const Surface<R>& b) {
  return {select(condition, a.position, b.position), select(condition, a.normal, b.normal),
          select(condition, a.offset, b.offset)};
}

/// Whether the hit is one of `count` primitives from `first` on.
template <class R>
MaskOf<R> isAmong(const Hit<R>& hit, int first, int count) {
  return hit.primitive >= IntOf<R>(first) && hit.primitive < IntOf<R>(first + count);
}

/// Which of them; 0 where it is none.
template <class R>
IntOf<R> indexAmong(const Hit<R>& hit, int first, int count) {
  return select(isAmong(hit, first, count), hit.primitive - IntOf<R>(first), IntOf<R>(0));
}

// These give the surface where the hit is of their kind, `other` elsewhere.

template <class R>
Surface<R> sphereOr(const SceneView& scene, const Ray<R>& ray, const Hit<R>& hit, int first,
                    const Surface<R>& other) {
  const int count = scene.index.sphereCount;
  const MaskOf<R> here = isAmong(hit, first, count);
  if (!scene.effectSphere || !anyLane(here)) return other;
  const Sphere<R> sphere = visitedSphere<R>(scene, indexAmong(hit, first, count));
  return chosenSurface(here, chosenSphereSurface(scene, ray, hit.t, sphere), other);
}

template <class R>
Surface<R> boxOr(const SceneView& scene, const Ray<R>& ray, const Hit<R>& hit, int first,
                 const Surface<R>& other) {
  const int count = scene.index.boxCount;
  const MaskOf<R> here = isAmong(hit, first, count);
  if (!scene.effectBox || !anyLane(here)) return other;
  const Box<R> box = visitedBox<R>(scene, indexAmong(hit, first, count));
  return chosenSurface(here, chosenBoxSurface(scene, ray, hit.t, box), other);
}

template <class R>
Surface<R> orientedBoxOr(const SceneView& scene, const Ray<R>& ray, const Hit<R>& hit, int first,
                         const Surface<R>& other) {
  const int count = scene.index.orientedBoxCount;
  const MaskOf<R> here = isAmong(hit, first, count);
  if (!scene.effectOrientedBox || !anyLane(here)) return other;
  const OrientedBox<R> box = visitedOrientedBox<R>(scene, indexAmong(hit, first, count));
  return chosenSurface(here, chosenOrientedBoxSurface(scene, ray, hit.t, box), other);
}

template <class R>
Surface<R> triangleOr(const SceneView& scene, const Ray<R>& ray, const Hit<R>& hit, int first,
                      const Surface<R>& other) {
  const int count = scene.index.triangleCount;
  const MaskOf<R> here = isAmong(hit, first, count);
  if (!scene.effectTriangle || !anyLane(here)) return other;
  const Triangle<R> triangle = visitedTriangle<R>(scene, indexAmong(hit, first, count));
  return chosenSurface(here, chosenTriangleSurface(scene, ray, hit.t, triangle), other);
}

template <class R>
Surface<R> planeOr(const SceneView& scene, const Ray<R>& ray, const Hit<R>& hit, int first,
                   const Surface<R>& other) {
  const int count = scene.index.planeCount;
  const MaskOf<R> here = isAmong(hit, first, count);
  if (!scene.effectPlane || !anyLane(here)) return other;
  const Plane<R> plane = visitedPlane<R>(scene, indexAmong(hit, first, count));
  return chosenSurface(here, chosenPlaneSurface(scene, ray, hit.t, plane), other);
}

/// The surface at a hit; for a miss, some surface without meaning.
template <class R>
Surface<R> surfaceAt(const SceneView& scene, const Ray<R>& ray, const Hit<R>& hit) {
  const SceneIndex& index = scene.index;
  const int firstBox = index.sphereCount;
  const int firstOrientedBox = firstBox + index.boxCount;
  const int firstTriangle = firstOrientedBox + index.orientedBoxCount;
  const int firstPlane = firstTriangle + index.triangleCount;
  const Surface<R> none{Vec3<R>(), Vec3<R>(R(0.0f), R(1.0f), R(0.0f)), R(0.0f)};
  const Surface<R> sphere = sphereOr(scene, ray, hit, 0, none);
  const Surface<R> box = boxOr(scene, ray, hit, firstBox, sphere);
  const Surface<R> orientedBox = orientedBoxOr(scene, ray, hit, firstOrientedBox, box);
  const Surface<R> triangle = triangleOr(scene, ray, hit, firstTriangle, orientedBox);
  return planeOr(scene, ray, hit, firstPlane, triangle);
}

/// The unit normal between those at a triangle's vertices, at a point of it; NaN where it has no
/// area.
template <class R>
Vec3<R> blendedNormal(const Triangle<R>& triangle, const Triangle<R>& normals, const Vec3<R>& p) {
  const Vec3<R> toA = triangle.a - p;
  const Vec3<R> toB = triangle.b - p;
  const Vec3<R> toC = triangle.c - p;
  const Vec3<R> areaA = cross3(toB, toC);
  const Vec3<R> areaB = cross3(toC, toA);
  const Vec3<R> areaC = cross3(toA, toB);
  const Vec3<R> area = (areaA + areaB) + areaC;
  const R a = greatest(R(0.0f), dot3(areaA, area));
  const R b = greatest(R(0.0f), dot3(areaB, area));
  const R c = greatest(R(0.0f), dot3(areaC, area));
  return normalize3((normals.a * a + normals.b * b) + normals.c * c);
}

/// The normal for shading at a hit: `facing`, the geometric one turned against d, but on smooth
/// triangles the blended one on the same side, where it faces the ray.
template <class R>
Vec3<R> shadingNormal(const SceneView& scene, const Hit<R>& hit, const Vec3<R>& p,
                      const Vec3<R>& facing, const Vec3<R>& d) {
  using Int = IntOf<R>;
  if (!scene.effectSmooth) return facing;
  const int first = scene.index.sphereCount + scene.index.boxCount + scene.index.orientedBoxCount;
  const Int triangle = indexAmong(hit, first, scene.index.triangleCount);
  const MaskOf<R> smoothHere = isAmong(hit, first, scene.index.triangleCount);
  if (!anyLane(smoothHere)) return facing;
  const Int record = fetchSmoothIndex<R>(scene, triangle);
  const MaskOf<R> has = smoothHere && record >= Int(0);
  const Triangle<R> normals = fetchNormals<R>(scene, select(has, record, Int(0)));
  const Vec3<R> blended = blendedNormal(visitedTriangle<R>(scene, triangle), normals, p);
  const Vec3<R> turned = select(dot3(blended, facing) < R(0.0f), -blended, blended);
  return select(has && dot3(turned, d) < R(0.0f), turned, facing);
}

TWINTRACE_KERNEL_END
