// The surface at a hit, whatever its primitive is.
#pragma once

#include "surface.glsl"

Surface chosenSurface(bool condition, Surface a, Surface b) {
  precise vec3 position = select(condition, a.position, b.position);
  precise vec3 normal = select(condition, a.normal, b.normal);
  precise float offset = select(condition, a.offset, b.offset);
  precise Surface result = Surface(position, normal, offset);
  return result;
}

// Whether the hit is one of `count` primitives from `first` on, and which of them: 0 where it is not.
bool isAmong(Hit hit, int first, int count) {
  int end = first + count;
  return hit.primitive >= first && hit.primitive < end;
}

int indexAmong(Hit hit, int first, int count) {
  return select(isAmong(hit, first, count), hit.primitive - first, 0);
}

// These give the surface where the hit is of their kind, `other` elsewhere.

Surface sphereOr(Ray ray, Hit hit, int first, Surface other) {
  precise Surface result = other;
  precise bool here = isAmong(hit, first, kSphereCount);
  if (kEffectSphere && anyLane(here)) {
    precise Sphere sphere = visitedSphere(indexAmong(hit, first, kSphereCount));
    precise Surface found = chosenSphereSurface(ray, hit.t, sphere);
    result = chosenSurface(here, found, other);
  }
  return result;
}

Surface boxOr(Ray ray, Hit hit, int first, Surface other) {
  precise Surface result = other;
  precise bool here = isAmong(hit, first, kBoxCount);
  if (kEffectBox && anyLane(here)) {
    precise Box box = visitedBox(indexAmong(hit, first, kBoxCount));
    precise Surface found = chosenBoxSurface(ray, hit.t, box);
    result = chosenSurface(here, found, other);
  }
  return result;
}

Surface orientedBoxOr(Ray ray, Hit hit, int first, Surface other) {
  precise Surface result = other;
  precise bool here = isAmong(hit, first, kOrientedBoxCount);
  if (kEffectOrientedBox && anyLane(here)) {
    precise OrientedBox box = visitedOrientedBox(indexAmong(hit, first, kOrientedBoxCount));
    precise Surface found = chosenOrientedBoxSurface(ray, hit.t, box);
    result = chosenSurface(here, found, other);
  }
  return result;
}

Surface triangleOr(Ray ray, Hit hit, int first, Surface other) {
  precise Surface result = other;
  precise bool here = isAmong(hit, first, kTriangleCount);
  if (kEffectTriangle && anyLane(here)) {
    precise Triangle triangle = visitedTriangle(indexAmong(hit, first, kTriangleCount));
    precise Surface found = chosenTriangleSurface(ray, hit.t, triangle);
    result = chosenSurface(here, found, other);
  }
  return result;
}

Surface planeOr(Ray ray, Hit hit, int first, Surface other) {
  precise Surface result = other;
  precise bool here = isAmong(hit, first, kPlaneCount);
  if (kEffectPlane && anyLane(here)) {
    precise Plane plane = visitedPlane(indexAmong(hit, first, kPlaneCount));
    precise Surface found = chosenPlaneSurface(ray, hit.t, plane);
    result = chosenSurface(here, found, other);
  }
  return result;
}

// The surface at a hit; for a miss, some surface without meaning.
Surface surfaceAt(Ray ray, Hit hit) {
  int firstBox = kSphereCount;
  int firstOrientedBox = firstBox + kBoxCount;
  int firstTriangle = firstOrientedBox + kOrientedBoxCount;
  int firstPlane = firstTriangle + kTriangleCount;
  precise Surface none = Surface(vec3(0.0f), vec3(0.0f, 1.0f, 0.0f), 0.0f);
  precise Surface sphere = sphereOr(ray, hit, 0, none);
  precise Surface box = boxOr(ray, hit, firstBox, sphere);
  precise Surface orientedBox = orientedBoxOr(ray, hit, firstOrientedBox, box);
  precise Surface triangle = triangleOr(ray, hit, firstTriangle, orientedBox);
  precise Surface result = planeOr(ray, hit, firstPlane, triangle);
  return result;
}

// The unit normal between those at a triangle's vertices, at a point of it; NaN where it has no area.
vec3 blendedNormal(Triangle triangle, Triangle normals, vec3 p) {
  precise vec3 toA = triangle.a - p;
  precise vec3 toB = triangle.b - p;
  precise vec3 toC = triangle.c - p;
  precise vec3 areaA = cross3(toB, toC);
  precise vec3 areaB = cross3(toC, toA);
  precise vec3 areaC = cross3(toA, toB);
  precise vec3 area = (areaA + areaB) + areaC;
  precise float a = greatest(0.0f, dot3(areaA, area));
  precise float b = greatest(0.0f, dot3(areaB, area));
  precise float c = greatest(0.0f, dot3(areaC, area));
  precise vec3 sum = (normals.a * a + normals.b * b) + normals.c * c;
  precise vec3 result = normalize3(sum);
  return result;
}

// The normal for shading at a hit: `facing`, the geometric one turned against d, but on smooth triangles
// the blended one on the same side. Where that faces away from the ray it stays `facing`.
vec3 shadingNormal(Hit hit, vec3 p, vec3 facing, vec3 d) {
  precise vec3 result = facing;
  int first = (kSphereCount + kBoxCount) + kOrientedBoxCount;
  int triangle = indexAmong(hit, first, kTriangleCount);
  precise bool smoothHere = kEffectSmooth && isAmong(hit, first, kTriangleCount);
  if (anyLane(smoothHere)) {
    int record = fetchSmoothIndex(triangle);
    precise bool has = smoothHere && record >= 0;
    precise Triangle normals = fetchNormals(select(has, record, 0));
    precise vec3 blended = blendedNormal(visitedTriangle(triangle), normals, p);
    precise vec3 turned = select(dot3(blended, facing) < 0.0f, -blended, blended);
    precise bool faces = has && dot3(turned, d) < 0.0f;
    result = select(faces, turned, facing);
  }
  return result;
}
