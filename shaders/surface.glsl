// The surface at a hit: a point that lies on it to within a few ulp, its normal, and how far a new
// ray's origin must move to have left it.
#pragma once

#include "geometry.glsl"

struct Surface {
  vec3 position;
  vec3 normal;   // unit; outward for spheres and boxes, as authored for planes
  float offset;  // distance along the normal that clears the surface
};

// A re-projected point is off by at most about 4 roundings of the largest coordinate involved, and
// the next intersection errs by as much again: 12 units of 2^-24.
const float kOffsetScale = 7.2e-7f;

// Only the rounding of each coordinate moves a plane's point and an origin above it, together by at most
// 2 units of 2^-24 of the coordinate: the next intersection is in double. 2.5 units leave a margin.
const float kPlaneOffsetScale = 1.5e-7f;
// Parts an origin from a plane at the scene's origin, where nothing is rounded; far above denormals.
const float kLeastOffset = 1e-30f;

// The report's fixed offset, in scene units.
const float kReportOffset = 1e-4f;

float largestCoordinate(vec3 v) {
  precise vec3 size = vec3(absolute(v.x), absolute(v.y), absolute(v.z));
  precise float result = largestComponent(size);
  return result;
}

// The step from the nearest point to a tangent's hit, in radii: enough for the normal's sign along the ray
// to be right in spite of rounding, since a flipped one sends the path inside.
const float kLeastAside = 9.5367431640625e-7f;

// Outward and unit, at the entry or exit that is closest to t: rounding may put the point at t itself
// anywhere in a small and far sphere, or outside. +y without a hit.
vec3 sphereNormal(Ray ray, float t, Sphere sphere) {
  precise SphereLine line = lineThrough(ray, sphere);
  precise SphereChord chord = chordOf(line, sphere.radius);
  precise float sinceEntry = t - chord.entry;
  precise float untilExit = chord.exit - t;
  precise bool entering = chord.entry >= ray.tmin && sinceEntry <= untilExit;
  precise float aside = greatest(chord.aside, kLeastAside);
  precise float step = select(entering, -aside, aside);
  precise vec3 unit = line.nearest + ray.direction * step;
  precise vec3 result = select(line.squared >= 0.0f, unit, vec3(0.0f, 1.0f, 0.0f));
  return result;
}

Surface sphereSurface(Ray ray, float t, Sphere sphere) {
  precise vec3 outward = sphereNormal(ray, t, sphere);
  precise vec3 position = sphere.center + outward * sphere.radius;
  precise float offset = (largestCoordinate(sphere.center) + sphere.radius) * kOffsetScale;
  precise Surface result = Surface(position, outward, offset);
  return result;
}

// The report's normal is that of the point at t, wherever it lies.
Surface reportSphereSurface(Ray ray, float t, Sphere sphere) {
  precise vec3 p = pointAt(ray, t);
  precise vec3 from = p - sphere.center;
  precise Surface result = Surface(p, normalize3(from), kReportOffset);
  return result;
}

Surface chosenSphereSurface(Ray ray, float t, Sphere sphere) {
  if (kIntersectorReport) {
    return reportSphereSurface(ray, t, sphere);
  }
  return sphereSurface(ray, t, sphere);
}

// How far the slab plane at `bound` is from being the one that was hit, and the best so far.
struct FaceChoice {
  float error;
  vec3 normal;
};

FaceChoice closerFace(FaceChoice best, float t, float planeT, vec3 normal) {
  precise float difference = planeT - t;
  precise float error = absolute(difference);
  precise bool better = error < best.error;
  precise FaceChoice result =
      FaceChoice(select(better, error, best.error), select(better, normal, best.normal));
  return result;
}

// The face whose plane distance, computed as in intersectBoxRobust, is t. The near faces come first,
// so that one that coincides with a far face (a box without thickness) is the one that was hit. NaN
// never is the closer.
FaceChoice hitFace(Ray ray, float t, Box box) {
  precise bool backX = ray.direction.x < 0.0f;
  precise bool backY = ray.direction.y < 0.0f;
  precise bool backZ = ray.direction.z < 0.0f;
  precise float x = select(backX, 1.0f, -1.0f);
  precise float y = select(backY, 1.0f, -1.0f);
  precise float z = select(backZ, 1.0f, -1.0f);
  precise vec3 low = (box.minimum - ray.origin) * ray.inverse;
  precise vec3 high = (box.maximum - ray.origin) * ray.inverse;
  precise FaceChoice best = FaceChoice(kInfinity, vec3(0.0f, 1.0f, 0.0f));
  best = closerFace(best, t, select(backX, high.x, low.x), vec3(x, 0.0f, 0.0f));
  best = closerFace(best, t, select(backY, high.y, low.y), vec3(0.0f, y, 0.0f));
  best = closerFace(best, t, select(backZ, high.z, low.z), vec3(0.0f, 0.0f, z));
  best = closerFace(best, t, select(backX, low.x, high.x), vec3(-x, 0.0f, 0.0f));
  best = closerFace(best, t, select(backY, low.y, high.y), vec3(0.0f, -y, 0.0f));
  best = closerFace(best, t, select(backZ, low.z, high.z), vec3(0.0f, 0.0f, -z));
  return best;
}

// The coordinate on the hit face: exactly the bound on the face's axis, held inside the box on the
// others.
float snapToFace(float x, float low, float high, float outward) {
  precise float held = clampTo(x, low, high);
  precise float lowOrHeld = select(outward < 0.0f, low, held);
  precise float result = select(outward > 0.0f, high, lowOrHeld);
  return result;
}

Surface boxSurface(Ray ray, float t, Box box) {
  precise vec3 normal = hitFace(ray, t, box).normal;
  precise vec3 p = pointAt(ray, t);
  precise vec3 position = vec3(snapToFace(p.x, box.minimum.x, box.maximum.x, normal.x),
                               snapToFace(p.y, box.minimum.y, box.maximum.y, normal.y),
                               snapToFace(p.z, box.minimum.z, box.maximum.z, normal.z));
  precise float low = largestCoordinate(box.minimum);
  precise float offset = greatest(low, largestCoordinate(box.maximum)) * kOffsetScale;
  precise Surface result = Surface(position, normal, offset);
  return result;
}

// The report's box normal: axes on which the point lies within 1e-4 of a face, added and normalised;
// a point that lies near none has no normal (NaN).
vec3 reportBoxNormal(vec3 p, vec3 center, vec3 halfSize) {
  precise vec3 from = p - center;
  precise float beyondX = absolute(from.x) - halfSize.x;
  precise float beyondY = absolute(from.y) - halfSize.y;
  precise float beyondZ = absolute(from.z) - halfSize.z;
  precise float gapX = absolute(beyondX);
  precise float gapY = absolute(beyondY);
  precise float gapZ = absolute(beyondZ);
  precise float x = select(gapX < 1e-4f, select(from.x < 0.0f, -1.0f, 1.0f), 0.0f);
  precise float y = select(gapY < 1e-4f, select(from.y < 0.0f, -1.0f, 1.0f), 0.0f);
  precise float z = select(gapZ < 1e-4f, select(from.z < 0.0f, -1.0f, 1.0f), 0.0f);
  precise vec3 result = normalize3(vec3(x, y, z));
  return result;
}

Surface reportBoxSurface(Ray ray, float t, Box box) {
  precise vec3 p = pointAt(ray, t);
  precise vec3 center = (box.minimum + box.maximum) * 0.5f;
  precise vec3 halfSize = (box.maximum - box.minimum) * 0.5f;
  precise Surface result = Surface(p, reportBoxNormal(p, center, halfSize), kReportOffset);
  return result;
}

Surface chosenBoxSurface(Ray ray, float t, Box box) {
  if (kIntersectorReport) {
    return reportBoxSurface(ray, t, box);
  }
  return boxSurface(ray, t, box);
}

// The point is brought to the slab's plane along the slab's axis, which need be neither unit nor
// orthogonal to the others; the normal is as long as that axis.
Surface orientedBoxSurface(Ray ray, float t, OrientedBox box) {
  precise Surface local = chosenBoxSurface(toLocalRay(ray, box), t, toLocalBox(box));
  precise vec3 normal = toWorldDirection(box, local.normal);
  precise vec3 p = pointAt(ray, t);
  precise vec3 from = p - box.center;
  precise vec3 axis = local.normal * local.normal;
  precise float beyond = dot3(from, normal) - dot3(axis, box.halfSize);
  precise vec3 position = p - normal * divide(beyond, dot3(normal, normal));
  precise float reach = greatest(largestCoordinate(position), largestCoordinate(box.center));
  precise float scaled = reach * kOffsetScale;
  precise float offset = select(kIntersectorReport, kReportOffset, scaled);
  precise Surface result = Surface(position, normal, offset);
  return result;
}

// p moved along the unit normal onto the plane through `point`.
vec3 broughtToPlane(vec3 p, vec3 point, vec3 normal) {
  precise dvec3 n = dvec3(normal);
  precise dvec3 from = dvec3(p) - dvec3(point);
  precise double height = (from.x * n.x + from.y * n.y) + from.z * n.z;
  precise dvec3 moved = dvec3(p) - n * height;
  precise vec3 result = vec3(float(moved.x), float(moved.y), float(moved.z));
  return result;
}

Surface planeSurface(Ray ray, float t, Plane plane) {
  precise vec3 position = broughtToPlane(pointAt(ray, t), plane.point, plane.normal);
  precise vec3 along = position * plane.normal;
  precise float rounding = (absolute(along.x) + absolute(along.y)) + absolute(along.z);
  precise float offset = rounding * kPlaneOffsetScale + kLeastOffset;
  precise Surface result = Surface(position, plane.normal, offset);
  return result;
}

Surface chosenSurface(bool condition, Surface a, Surface b) {
  precise vec3 position = select(condition, a.position, b.position);
  precise vec3 normal = select(condition, a.normal, b.normal);
  precise float offset = select(condition, a.offset, b.offset);
  precise Surface result = Surface(position, normal, offset);
  return result;
}

// The surface at a hit; for a miss, some surface without meaning.
Surface surfaceAt(Ray ray, Hit hit) {
  precise Surface result = Surface(vec3(0.0f), vec3(0.0f, 1.0f, 0.0f), 0.0f);
  int first = 0;
  if (kEffectSphere) {
    precise bool here = hit.primitive < kSphereCount;
    if (anyLane(here)) {
      precise Sphere sphere = visitedSphere(select(here, hit.primitive, 0));
      precise Surface found = chosenSphereSurface(ray, hit.t, sphere);
      result = chosenSurface(here, found, result);
    }
  }
  first += kSphereCount;
  if (kEffectBox) {
    precise bool here = hit.primitive >= first && hit.primitive < first + kBoxCount;
    if (anyLane(here)) {
      precise Box box = visitedBox(select(here, hit.primitive - first, 0));
      precise Surface found = chosenBoxSurface(ray, hit.t, box);
      result = chosenSurface(here, found, result);
    }
  }
  first += kBoxCount;
  if (kEffectOrientedBox) {
    precise bool here = hit.primitive >= first && hit.primitive < first + kOrientedBoxCount;
    if (anyLane(here)) {
      precise OrientedBox box = visitedOrientedBox(select(here, hit.primitive - first, 0));
      precise Surface found = orientedBoxSurface(ray, hit.t, box);
      result = chosenSurface(here, found, result);
    }
  }
  first += kOrientedBoxCount;
  if (kEffectPlane) {
    precise bool here = hit.primitive >= first && hit.primitive < first + kPlaneCount;
    if (anyLane(here)) {
      precise Plane plane = visitedPlane(select(here, hit.primitive - first, 0));
      precise Surface found = planeSurface(ray, hit.t, plane);
      result = chosenSurface(here, found, result);
    }
  }
  if (kIntersectorReport) {
    result.position = pointAt(ray, hit.t);
    result.offset = kReportOffset;
  }
  return result;
}

// Origin for a ray that leaves the surface along the side of `facing`, the normal or its opposite.
vec3 leavingOrigin(Surface surface, vec3 facing) {
  precise vec3 result = surface.position + facing * surface.offset;
  return result;
}
