// Intersections by the chosen intersector.
#pragma once

#include "intersect_report.glsl"
#include "intersect_robust.glsl"
#include "intersect_triangle.glsl"

float intersectSphere(Ray ray, Sphere sphere) {
  if (kIntersectorReport) {
    return intersectSphereReport(ray, sphere);
  }
  return intersectSphereRobust(ray, sphere);
}

float intersectBox(Ray ray, Box box) {
  if (kIntersectorReport) {
    return intersectBoxReport(ray, box);
  }
  return intersectBoxRobust(ray, box);
}

vec3 toLocalDirection(OrientedBox box, vec3 v) {
  precise vec3 result = vec3(dot3(box.axisX, v), dot3(box.axisY, v), dot3(box.axisZ, v));
  return result;
}

vec3 toWorldDirection(OrientedBox box, vec3 v) {
  precise vec3 result = (box.axisX * v.x + box.axisY * v.y) + box.axisZ * v.z;
  return result;
}

Ray toLocalRay(Ray ray, OrientedBox box) {
  precise vec3 fromCenter = ray.origin - box.center;
  precise vec3 origin = toLocalDirection(box, fromCenter);
  precise vec3 direction = toLocalDirection(box, ray.direction);
  precise Ray result = makeRay(origin, direction, ray.tmin, ray.tmax);
  return result;
}

// The box about the origin of an oriented box's own frame.
Box toLocalBox(OrientedBox box) {
  precise Box result = Box(-box.halfSize, box.halfSize);
  return result;
}

float intersectOrientedBox(Ray ray, OrientedBox box) {
  precise Ray local = toLocalRay(ray, box);
  precise float result = intersectBox(local, toLocalBox(box));
  return result;
}

float intersectPlane(Ray ray, Plane plane) {
  if (kIntersectorReport) {
    return intersectPlaneReport(ray, plane);
  }
  return intersectPlaneRobust(ray, plane);
}

float intersectTriangle(Ray ray, Triangle triangle) {
  if (kIntersectorReport) {
    return intersectTriangleReport(ray, triangle);
  }
  return intersectTriangleRobust(ray, triangle);
}
