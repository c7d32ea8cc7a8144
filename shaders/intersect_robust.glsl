// Intersections that stay right far from the origin, at grazing angles, for any direction's length
// and from inside: no epsilon in scene units. Each returns the first distance t >= tmin, or infinity
// for a miss.
#pragma once

#include "ray.glsl"
#include "records.glsl"

// 2 gamma(3): how far rounding can move a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
const float kSlabWidening = 7.2e-7f;

// Haines, Guenther and Akenine-Moeller 2019, "Precision Improvements for Ray/Sphere Intersection"
// (Ray Tracing Gems, ch. 7), for directions of any length. Changed: written in select form; the
// quotient that is 0/0 for an origin at the point of contact is dropped by `least`.
float intersectSphereRobust(Ray ray, Sphere sphere) {
  precise vec3 f = ray.origin - sphere.center;
  precise float a = dot3(ray.direction, ray.direction);
  precise float b = -dot3(f, ray.direction);
  precise vec3 toAxis = f + ray.direction * divide(b, a);
  precise float r2 = sphere.radius * sphere.radius;
  precise float discriminant = r2 - dot3(toAxis, toAxis);
  precise float scaled = a * greatest(discriminant, 0.0f);
  precise float root = squareRoot(scaled);
  precise float less = b - root;
  precise float more = b + root;
  precise float q = select(b < 0.0f, less, more);
  precise float c = dot3(f, f) - r2;
  precise float t0 = divide(c, q);
  precise float t1 = divide(q, a);
  precise float first = least(t1, t0);
  precise float second = greatest(t1, t0);
  precise float t = select(first >= ray.tmin, first, second);
  precise bool valid = discriminant >= 0.0f && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}

// Kay and Kajiya 1986 slabs. Near and far plane are picked by the direction's sign; a zero component
// has an infinite inverse, so that an origin outside the slab gives an empty interval, one inside
// an unbounded one, and one on a face 0 * infinity = NaN, which least and greatest drop.
float intersectBoxRobust(Ray ray, Box box) {
  precise bool backX = ray.direction.x < 0.0f;
  precise bool backY = ray.direction.y < 0.0f;
  precise bool backZ = ray.direction.z < 0.0f;
  precise float nearX = (select(backX, box.maximum.x, box.minimum.x) - ray.origin.x) * ray.inverse.x;
  precise float nearY = (select(backY, box.maximum.y, box.minimum.y) - ray.origin.y) * ray.inverse.y;
  precise float nearZ = (select(backZ, box.maximum.z, box.minimum.z) - ray.origin.z) * ray.inverse.z;
  precise float farX = (select(backX, box.minimum.x, box.maximum.x) - ray.origin.x) * ray.inverse.x;
  precise float farY = (select(backY, box.minimum.y, box.maximum.y) - ray.origin.y) * ray.inverse.y;
  precise float farZ = (select(backZ, box.minimum.z, box.maximum.z) - ray.origin.z) * ray.inverse.z;
  precise float entry = greatest(greatest(greatest(-kInfinity, nearX), nearY), nearZ);
  precise float exit = least(least(least(kInfinity, farX), farY), farZ);
  precise float widened = exit * (1.0f + kSlabWidening);
  precise float t = select(entry < ray.tmin, exit, entry);
  precise bool valid = entry <= widened && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}

// t = num / den with no threshold on den: a parallel ray gives infinity or NaN, which is a miss.
float intersectPlaneRobust(Ray ray, Plane plane) {
  precise vec3 toPlane = plane.point - ray.origin;
  precise float height = dot3(toPlane, plane.normal);
  precise float t = divide(height, dot3(plane.normal, ray.direction));
  precise bool valid = t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}
