#pragma once

// Twin of shaders/intersect.glsl: intersections by the chosen intersector.

#include "cpu/kernel/intersect_report.h"
#include "cpu/kernel/intersect_robust.h"
#include "cpu/kernel/intersect_triangle.h"
#include "cpu/kernel/scene_view.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
R intersectSphere(const SceneView& scene, const Ray<R>& ray, const Sphere<R>& sphere) {
  if (scene.intersectorReport) return intersectSphereReport(ray, sphere);
  return intersectSphereRobust(ray, sphere);
}

template <class R>
R intersectBox(const SceneView& scene, const Ray<R>& ray, const Box<R>& box) {
  if (scene.intersectorReport) return intersectBoxReport(ray, box);
  return intersectBoxRobust(ray, box);
}

template <class R>
Vec3<R> toLocalDirection(const OrientedBox<R>& box, const Vec3<R>& v) {
  return {dot3(box.axisX, v), dot3(box.axisY, v), dot3(box.axisZ, v)};
}

template <class R>
Vec3<R> toWorldDirection(const OrientedBox<R>& box, const Vec3<R>& v) {
  return (box.axisX * v.x + box.axisY * v.y) + box.axisZ * v.z;
}

template <class R>
Ray<R> toLocalRay(const Ray<R>& ray, const OrientedBox<R>& box) {
  const Vec3<R> origin = toLocalDirection(box, ray.origin - box.center);
  const Vec3<R> direction = toLocalDirection(box, ray.direction);
  return makeRay(origin, direction, ray.tmin, ray.tmax);
}

/// The box about the origin of an oriented box's own frame.
template <class R>
Box<R> toLocalBox(const OrientedBox<R>& box) {
  return {-box.halfSize, box.halfSize};
}

template <class R>
R intersectOrientedBox(const SceneView& scene, const Ray<R>& ray, const OrientedBox<R>& box) {
  return intersectBox(scene, toLocalRay(ray, box), toLocalBox(box));
}

template <class R>
R intersectPlane(const SceneView& scene, const Ray<R>& ray, const Plane<R>& plane) {
  if (scene.intersectorReport) return intersectPlaneReport(ray, plane);
  return intersectPlaneRobust(ray, plane);
}

template <class R>
R intersectTriangle(const SceneView& scene, const Ray<R>& ray, const Triangle<R>& triangle) {
  if (scene.intersectorReport) return intersectTriangleReport(ray, triangle);
  return intersectTriangleRobust(ray, triangle);
}

TWINTRACE_KERNEL_END
