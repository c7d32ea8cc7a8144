// Intersections as the report has them, faults included: fixed epsilons, no hits from inside spheres
// and boxes, unit directions assumed. Each returns the distance, or infinity for a miss.
#pragma once

#include "ray.glsl"
#include "records.glsl"

// Report algorithm 2.
float intersectSphereReport(Ray ray, Sphere sphere) {
  precise vec3 toCenter = sphere.center - ray.origin;
  precise float along = dot3(toCenter, ray.direction);
  precise vec3 nearest = ray.origin + ray.direction * along;
  precise vec3 aside = sphere.center - nearest;
  precise float distance = length3(aside);
  precise float r = sphere.radius;
  precise float halfSquared = r * r - distance * distance;
  precise float halfChord = squareRoot(greatest(halfSquared, 0.0f));
  precise float t = along - halfChord;
  precise bool valid = distance < r && t > 0.0f && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}

// Report eq. 3-5, algorithm 1.
float intersectBoxReport(Ray ray, Box box) {
  precise vec3 below = box.minimum - ray.origin;
  precise vec3 above = box.maximum - ray.origin;
  precise vec3 t0 = vec3(divide(below.x, ray.direction.x), divide(below.y, ray.direction.y),
                         divide(below.z, ray.direction.z));
  precise vec3 t1 = vec3(divide(above.x, ray.direction.x), divide(above.y, ray.direction.y),
                         divide(above.z, ray.direction.z));
  precise vec3 low = vec3(least(t0.x, t1.x), least(t0.y, t1.y), least(t0.z, t1.z));
  precise vec3 high = vec3(greatest(t0.x, t1.x), greatest(t0.y, t1.y), greatest(t0.z, t1.z));
  precise float entry = greatest(-1e14f, largestComponent(low));
  precise float exit = least(1e14f, least(least(high.x, high.y), high.z));
  precise bool valid = entry >= 0.0f && entry <= exit && entry >= ray.tmin;
  precise float result = select(valid, entry, kInfinity);
  return result;
}

// Report eq. 7.
float intersectPlaneReport(Ray ray, Plane plane) {
  precise float facing = dot3(plane.normal, ray.direction);
  precise vec3 toPlane = plane.point - ray.origin;
  precise float t = divide(dot3(toPlane, plane.normal), facing);
  precise float size = absolute(facing);
  precise bool valid = size > 1e-4f && t >= 1e-4f && t >= ray.tmin;
  precise float result = select(valid, t, kInfinity);
  return result;
}
