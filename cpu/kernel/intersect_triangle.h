#pragma once

// Twin of shaders/intersect_triangle.glsl: intersections with triangles, seen from both sides.

#include "cpu/kernel/ray.h"
#include "cpu/kernel/records.h"

TWINTRACE_KERNEL_BEGIN

/// Below this determinant Moeller and Trumbore take a ray for parallel.
inline constexpr float kReportDeterminant = 1e-7f;

/// Moeller and Trumbore 1997, without culling.
template <class R>
R intersectTriangleReport(const Ray<R>& ray, const Triangle<R>& triangle) {
  const Vec3<R> edge1 = triangle.b - triangle.a;
  const Vec3<R> edge2 = triangle.c - triangle.a;
  const Vec3<R> p = cross3(ray.direction, edge2);
  const R determinant = dot3(edge1, p);
  const R inverse = divide(R(1.0f), determinant);
  const Vec3<R> fromA = ray.origin - triangle.a;
  const R u = dot3(fromA, p) * inverse;
  const Vec3<R> q = cross3(fromA, edge1);
  const R v = dot3(ray.direction, q) * inverse;
  const R t = dot3(edge2, q) * inverse;
  const R size = absolute(determinant);
  const MaskOf<R> inside = u >= R(0.0f) && v >= R(0.0f) && u + v <= R(1.0f);
  const MaskOf<R> valid = size >= R(kReportDeterminant) && inside && t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

/// v with its components turned round so that the one on the direction's longest axis is the last.
template <class R>
Vec3<R> turnedAlong(const Vec3<R>& direction, const Vec3<R>& v) {
  const R x = absolute(direction.x);
  const R y = absolute(direction.y);
  const R z = absolute(direction.z);
  const MaskOf<R> alongX = x >= y && x >= z;
  const MaskOf<R> alongY = y >= z;
  const Vec3<R> alongYOrZ = select(alongY, Vec3<R>(v.z, v.x, v.y), v);
  return select(alongX, Vec3<R>(v.y, v.z, v.x), alongYOrZ);
}

/// Where the vertex lies beside the ray, times the direction's last component; z is the vertex's own.
template <class R>
Vec3<R> beside(const Vec3<R>& direction, const Vec3<R>& vertex) {
  const WiderOf<R> x = differenceOfProducts(vertex.x, direction.z, vertex.z, direction.x);
  const WiderOf<R> y = differenceOfProducts(vertex.y, direction.z, vertex.z, direction.y);
  return {rounded<R>(x), rounded<R>(y), vertex.z};
}

/// Woop, Benthin and Wald 2013, with exact edge functions: see shaders/intersect_triangle.glsl.
/// @param ray its direction's largest component is within [0.5, 2).
template <class R>
R intersectTriangleRobust(const Ray<R>& ray, const Triangle<R>& triangle) {
  using Wider = WiderOf<R>;
  const Vec3<R> d = turnedAlong(ray.direction, ray.direction);
  const Vec3<R> a = beside(d, turnedAlong(ray.direction, triangle.a - ray.origin));
  const Vec3<R> b = beside(d, turnedAlong(ray.direction, triangle.b - ray.origin));
  const Vec3<R> c = beside(d, turnedAlong(ray.direction, triangle.c - ray.origin));
  const Wider u = differenceOfProducts(c.x, b.y, c.y, b.x);
  const Wider v = differenceOfProducts(a.x, c.y, a.y, c.x);
  const Wider w = differenceOfProducts(b.x, a.y, b.y, a.x);
  const Wider determinant = (u + v) + w;
  const Wider weighted = (u * wider(a.z) + v * wider(b.z)) + w * wider(c.z);
  const R t = rounded<R>(weighted / (determinant * wider(d.z)));
  const Wider zero(0.0f);
  const MaskOf<R> front = u >= zero && v >= zero && w >= zero && determinant > zero;
  const MaskOf<R> back = u <= zero && v <= zero && w <= zero && determinant < zero;
  const MaskOf<R> valid = (front || back) && t >= ray.tmin;
  return select(valid, t, R(kInfinity));
}

TWINTRACE_KERNEL_END
