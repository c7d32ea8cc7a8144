// Intersections that stay right far from the origin, at grazing angles, for any direction's length
// and from inside: no epsilon in scene units. Each returns the first distance t >= tmin, or
// infinity for a miss.
#pragma once

#include "ray.glsl"
#include "records.glsl"

// 2 gamma(3): how far rounding can move a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
const float kSlabWidening = 7.2e-7f;

// A ray's line seen from a sphere: relative to the center and in radii, but for `t`.
struct SphereLine {
  vec3 nearest;   // the line's point nearest to the center
  float t;        // the ray's t at a point of the line near that one
  float ahead;    // step along the direction from there to the nearest point
  float halfChordSquared;  // squared step from the nearest point to either hit; below 0 for a miss
};

// Where the line meets the sphere: the step from the nearest point to either hit, and the hits' t.
// Without meaning for a line that misses.
struct SphereChord {
  float halfChord;
  float entry;
  float exit;
};

// Haines, Guenther and Akenine-Moeller 2019, "Precision Improvements for Ray/Sphere Intersection"
// (Ray Tracing Gems, ch. 7), who take the discriminant from the line's point nearest to the center.
// Changed: a point close to it is rounded once, from products in double; from there on the sphere
// is a unit sphere seen from close by, for which float is enough, and no length is squared before
// it is in radii. A sphere of radius 0 is never hit. The direction's largest component is within
// [0.5, 2).
SphereLine sphereLineOf(Ray ray, Sphere sphere) {
  precise vec3 d = ray.direction;
  precise vec3 f = ray.origin - sphere.center;
  precise float inverse = divide(1.0f, dot3(d, d));
  precise float t = -dot3(f, d) * inverse;
  precise dvec3 from = dvec3(ray.origin) - dvec3(sphere.center);
  // 1 / radius would be denormal for the largest radii, and flushed to zero; 4 / radius never is.
  precise float scale = divide(4.0f, sphere.radius);
  precise dvec3 exact = from + dvec3(d) * double(t);
  precise vec3 close = vec3(float(exact.x), float(exact.y), float(exact.z));
  precise vec3 foot = (close * scale) * 0.25f;
  precise float ahead = -dot3(foot, d) * inverse;
  precise vec3 nearest = foot + d * ahead;
  precise float halfChordSquared = (1.0f - dot3(nearest, nearest)) * inverse;
  precise SphereLine result = SphereLine(nearest, t, ahead, halfChordSquared);
  return result;
}

SphereChord chordOf(SphereLine line, float radius) {
  precise float halfChord = squareRoot(line.halfChordSquared);
  precise float entry = line.t + (line.ahead - halfChord) * radius;
  precise float exit = line.t + (line.ahead + halfChord) * radius;
  precise SphereChord result = SphereChord(halfChord, entry, exit);
  return result;
}

float intersectSphereRobust(Ray ray, Sphere sphere) {
  precise SphereLine line = sphereLineOf(ray, sphere);
  precise SphereChord chord = chordOf(line, sphere.radius);
  precise float t = select(chord.entry >= ray.tmin, chord.entry, chord.exit);
  precise bool valid = line.halfChordSquared >= 0.0f && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}

// Distances along a ray to the planes of a box's slabs, and the interval between the last that
// enters and the first that leaves.
struct Slabs {
  vec3 near;
  vec3 far;
  float entry;
  float exit;
};

// Infinity for every ray, which no compiler knows beforehand: of minima and maxima that start from
// a literal, llvmpipe makes comparisons and selections, which take 5 % of a frame.
float computedInfinity(Ray ray) {
  precise float result = float(floatBitsToInt(ray.inverse.x)) + kInfinity;
  return result;
}

// Kay and Kajiya 1986. Near and far plane are picked by the direction's sign; a zero component has
// an infinite inverse, so that an origin outside the slab gives an empty interval, one inside an
// unbounded one, and one on a face 0 * infinity = NaN, which least and greatest drop.
Slabs slabsOf(Ray ray, Box box) {
  precise bool backX = ray.direction.x < 0.0f;
  precise bool backY = ray.direction.y < 0.0f;
  precise bool backZ = ray.direction.z < 0.0f;
  precise vec3 first = vec3(select(backX, box.maximum.x, box.minimum.x),
                            select(backY, box.maximum.y, box.minimum.y),
                            select(backZ, box.maximum.z, box.minimum.z));
  precise vec3 last = vec3(select(backX, box.minimum.x, box.maximum.x),
                           select(backY, box.minimum.y, box.maximum.y),
                           select(backZ, box.minimum.z, box.maximum.z));
  precise vec3 near = (first - ray.origin) * ray.inverse;
  precise vec3 far = (last - ray.origin) * ray.inverse;
  precise float unbounded = computedInfinity(ray);
  precise float entry = greatest(greatest(greatest(-unbounded, near.x), near.y), near.z);
  precise float exit = least(least(least(unbounded, far.x), far.y), far.z);
  precise Slabs result = Slabs(near, far, entry, exit);
  return result;
}

float intersectBoxRobust(Ray ray, Box box) {
  precise Slabs slabs = slabsOf(ray, box);
  precise float widened = slabs.exit * (1.0f + kSlabWidening);
  precise float t = select(slabs.entry < ray.tmin, slabs.exit, slabs.entry);
  precise bool valid = slabs.entry <= widened && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}

// t = num / den with no threshold on den, in double, since in a nearly parallel ray's den little is
// left of its terms: an exactly parallel ray gives infinity or NaN, which is a miss.
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
