// Intersections with triangles, seen from both sides, by both intersectors.
#pragma once

#include "ray.glsl"
#include "records.glsl"

// Below this determinant Moeller and Trumbore take a ray for parallel: an area in scene units, so
// that small triangles vanish.
const float kReportDeterminant = 1e-7f;

// Moeller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection", the variant without
// culling.
float intersectTriangleReport(Ray ray, Triangle triangle) {
  precise vec3 edge1 = triangle.b - triangle.a;
  precise vec3 edge2 = triangle.c - triangle.a;
  precise vec3 p = cross3(ray.direction, edge2);
  precise float determinant = dot3(edge1, p);
  precise float inverse = divide(1.0f, determinant);
  precise vec3 fromA = ray.origin - triangle.a;
  precise float u = dot3(fromA, p) * inverse;
  precise vec3 q = cross3(fromA, edge1);
  precise float v = dot3(ray.direction, q) * inverse;
  precise float t = dot3(edge2, q) * inverse;
  precise float size = absolute(determinant);
  precise float sum = u + v;
  precise bool inside = u >= 0.0f && v >= 0.0f && sum <= 1.0f;
  precise bool valid = size >= kReportDeterminant && inside && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}

// v with its components turned round so that the one on the direction's longest axis is the last.
vec3 turnedAlong(vec3 direction, vec3 v) {
  precise float x = absolute(direction.x);
  precise float y = absolute(direction.y);
  precise float z = absolute(direction.z);
  precise bool alongX = x >= y && x >= z;
  precise bool alongY = y >= z;
  precise vec3 alongYOrZ = select(alongY, vec3(v.z, v.x, v.y), v);
  precise vec3 result = select(alongX, vec3(v.y, v.z, v.x), alongYOrZ);
  return result;
}

// x and y: where the vertex lies beside the ray, in the plane across its longest axis, times the
// direction's last component; z is the vertex's own.
vec3 beside(vec3 direction, vec3 vertex) {
  precise double x =
      double(vertex.x) * double(direction.z) - double(vertex.z) * double(direction.x);
  precise double y =
      double(vertex.y) * double(direction.z) - double(vertex.z) * double(direction.y);
  precise vec3 result = vec3(float(x), float(y), vertex.z);
  return result;
}

// Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection", whose two-dimensional
// triangle has exact edge functions here, so that triangles with a common edge leave no gap. Changed:
// the shear multiplies by the direction's last component instead of dividing by it, from exact
// products, and edge functions are never in float, where slivers lose them. A triangle whose image is
// a line or a point is missed. The direction's largest component is within [0.5, 2).
float intersectTriangleRobust(Ray ray, Triangle triangle) {
  precise vec3 d = turnedAlong(ray.direction, ray.direction);
  precise vec3 fromA = triangle.a - ray.origin;
  precise vec3 fromB = triangle.b - ray.origin;
  precise vec3 fromC = triangle.c - ray.origin;
  precise vec3 a = beside(d, turnedAlong(ray.direction, fromA));
  precise vec3 b = beside(d, turnedAlong(ray.direction, fromB));
  precise vec3 c = beside(d, turnedAlong(ray.direction, fromC));
  precise double u = double(c.x) * double(b.y) - double(c.y) * double(b.x);
  precise double v = double(a.x) * double(c.y) - double(a.y) * double(c.x);
  precise double w = double(b.x) * double(a.y) - double(b.y) * double(a.x);
  precise double determinant = (u + v) + w;
  precise double weighted = (u * double(a.z) + v * double(b.z)) + w * double(c.z);
  precise double quotient = weighted / (determinant * double(d.z));
  precise float t = float(quotient);
  precise bool front = u >= 0.0f && v >= 0.0f && w >= 0.0f && determinant > 0.0f;
  precise bool back = u <= 0.0f && v <= 0.0f && w <= 0.0f && determinant < 0.0f;
  precise bool valid = (front || back) && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}
