// Intersections that stay right far from the origin, at grazing angles, for any direction's length
// and from inside: no epsilon in scene units. Each returns the first distance t >= tmin, or infinity
// for a miss.
#pragma once

#include "ray.glsl"
#include "records.glsl"

// 2 gamma(3): how far rounding can move a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
const float kSlabWidening = 7.2e-7f;

// The sphere's discriminant and its value at the origin err by less than this part of the squared
// lengths that they are the difference of (at most 8 roundings of 2^-24, times 2).
const float kSphereDoubt = 9.5367431640625e-7f;
// Squared lengths within which no product of the test overflows or loses bits to underflow.
const float kLeastSquare = 1e-24f;
const float kMostSquare = 1e36f;

// Haines, Guenther and Akenine-Moeller 2019, "Precision Improvements for Ray/Sphere Intersection"
// (Ray Tracing Gems, ch. 7), in double, where no lengths of floats overflow. Changed: written in
// select form; the quotient that is 0/0 for an origin at the point of contact is left out.
float intersectSphereInDouble(Ray ray, Sphere sphere) {
  precise dvec3 d = dvec3(ray.direction);
  precise dvec3 f = dvec3(ray.origin) - dvec3(sphere.center);
  precise double a = (d.x * d.x + d.y * d.y) + d.z * d.z;
  precise double b = -((f.x * d.x + f.y * d.y) + f.z * d.z);
  precise double middle = b / a;
  precise dvec3 toAxis = f + d * middle;
  precise double r2 = double(sphere.radius) * double(sphere.radius);
  precise double l2 = (toAxis.x * toAxis.x + toAxis.y * toAxis.y) + toAxis.z * toAxis.z;
  precise double discriminant = r2 - l2;
  precise double scaled = a * discriminant;
  precise double root = sqrt(scaled);
  precise double less = b - root;
  precise double more = b + root;
  precise double c = ((f.x * f.x + f.y * f.y) + f.z * f.z) - r2;
  precise bool backwards = b < 0.0f;
  precise double fromLess = c / less;
  precise double fromMore = c / more;
  precise double atLess = less / a;
  precise double atMore = more / a;
  precise float t0 = select(backwards, float(fromLess), float(fromMore));
  precise float t1 = select(backwards, float(atLess), float(atMore));
  precise float first = least(t1, t0);
  precise float second = greatest(t1, t0);
  precise float t = select(first >= ray.tmin, first, second);
  precise bool valid = discriminant >= 0.0f && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}

// The same in float, and in double for the few rays of which float cannot tell whether they touch the
// sphere, on which side of it they begin, or whose lengths have no squares. A loop, since llvmpipe
// leaves one that no lane enters, but runs both sides of an `if`. The direction's largest component is
// within [0.5, 2).
float intersectSphereRobust(Ray ray, Sphere sphere) {
  precise vec3 f = ray.origin - sphere.center;
  precise float a = dot3(ray.direction, ray.direction);
  precise float b = -dot3(f, ray.direction);
  precise vec3 toAxis = f + ray.direction * divide(b, a);
  precise float r2 = sphere.radius * sphere.radius;
  precise float f2 = dot3(f, f);
  precise float discriminant = r2 - dot3(toAxis, toAxis);
  precise float c = f2 - r2;
  precise float squares = f2 + r2;
  precise float doubt = squares * kSphereDoubt;
  precise bool passes = discriminant < -doubt;
  precise bool meets = discriminant > doubt && absolute(c) > doubt;
  precise bool sure = (passes || meets) && squares > kLeastSquare && squares < kMostSquare;
  precise float scaled = a * discriminant;
  precise float root = squareRoot(scaled);
  precise float less = b - root;
  precise float more = b + root;
  precise float q = select(b < 0.0f, less, more);
  precise float t0 = divide(c, q);
  precise float t1 = divide(q, a);
  precise float first = least(t1, t0);
  precise float second = greatest(t1, t0);
  precise float t = select(first >= ray.tmin, first, second);
  precise bool valid = meets && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  precise bool pending = !sure;
  while (pending) {
    result = intersectSphereInDouble(ray, sphere);
    pending = false;
  }
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

// t = num / den with no threshold on den, in double, since in a nearly parallel ray's den little is left
// of its terms: an exactly parallel ray gives infinity or NaN, which is a miss.
float intersectPlaneRobust(Ray ray, Plane plane) {
  precise dvec3 n = dvec3(plane.normal);
  precise dvec3 d = dvec3(ray.direction);
  precise dvec3 toPlane = dvec3(plane.point) - dvec3(ray.origin);
  precise double height = (toPlane.x * n.x + toPlane.y * n.y) + toPlane.z * n.z;
  precise double facing = (d.x * n.x + d.y * n.y) + d.z * n.z;
  precise double quotient = height / facing;
  precise float t = float(quotient);
  precise bool valid = t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}
