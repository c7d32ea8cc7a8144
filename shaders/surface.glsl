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

// Where the next intersection tells exactly on which side of the surface its origin lies (a plane's
// is in double, a slab's one subtraction), only the rounding of each coordinate moves a point and
// an origin above it: together by at most 2 units of 2^-24 of the coordinate. 2.5 units leave a
// margin.
const float kClearanceScale = 1.5e-7f;
// Parts an origin from a surface at the scene's origin, where nothing is rounded; far above
// denormals.
const float kLeastClearance = 1e-30f;

// Going into an oriented box's frame and out of it costs 4 roundings each of the products that make
// up the distance from its center: 8.5 units of 2^-24 of their sizes. Its axes are unit to within
// rounding.
const float kFrameScale = 5.1e-7f;

// The report's fixed offset, in scene units.
const float kReportOffset = 1e-4f;

float largestCoordinate(vec3 v) {
  precise vec3 size = vec3(absolute(v.x), absolute(v.y), absolute(v.z));
  precise float result = largestComponent(size);
  return result;
}

// The sizes of the products in v . normal, added up.
float sizeAlong(vec3 v, vec3 normal) {
  precise vec3 along = v * normal;
  precise float result = (absolute(along.x) + absolute(along.y)) + absolute(along.z);
  return result;
}

// Offset of a point off which only its coordinates' rounding can move an origin.
float clearance(vec3 position, vec3 normal) {
  precise float result = sizeAlong(position, normal) * kClearanceScale + kLeastClearance;
  return result;
}

// The step from the nearest point to a tangent's hit, in radii: enough for the normal's sign along
// the ray to be right in spite of rounding, since a flipped one sends the path inside.
const float kLeastHalfChord = 9.5367431640625e-7f;

// Outward and unit, at the entry or exit that is closest to t: rounding may put the point at t
// itself anywhere in a small and far sphere, or outside. Without meaning for a miss.
vec3 sphereNormal(Ray ray, float t, Sphere sphere) {
  precise SphereLine line = sphereLineOf(ray, sphere);
  precise SphereChord chord = chordOf(line, sphere.radius);
  precise float sinceEntry = t - chord.entry;
  precise float untilExit = chord.exit - t;
  precise bool entering = chord.entry >= ray.tmin && sinceEntry <= untilExit;
  // The second, if NaN, is dropped: native maths may evaluate a tangent's line otherwise here.
  precise float halfChord = greatest(kLeastHalfChord, chord.halfChord);
  precise float step = select(entering, -halfChord, halfChord);
  precise vec3 result = line.nearest + ray.direction * step;
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

// A face of a box: of its z slab if of neither other, and the side on which its outside lies, -1 or
// 1.
struct BoxFace {
  bool ofX;
  bool ofY;
  float outward;
};

// The face by which the ray enters or leaves, whichever is closer to t; of two that coincide (a box
// without thickness) the one by which it enters, also where slabs that were widened let it leave
// before. Some face for a miss.
BoxFace hitFace(Ray ray, float t, Box box) {
  precise Slabs slabs = slabsOf(ray, box);
  precise float sinceEntry = t - slabs.entry;
  precise float untilExit = slabs.exit - t;
  precise bool entering = slabs.entry >= ray.tmin && sinceEntry <= absolute(untilExit);
  precise float bound = select(entering, slabs.entry, slabs.exit);
  precise bool ofX = select(entering, slabs.near.x, slabs.far.x) == bound;
  precise bool ofY = !ofX && select(entering, slabs.near.y, slabs.far.y) == bound;
  precise float along = select(ofX, ray.direction.x, select(ofY, ray.direction.y, ray.direction.z));
  precise bool toMinimum = (along < 0.0f) != entering;
  precise BoxFace result = BoxFace(ofX, ofY, select(toMinimum, -1.0f, 1.0f));
  return result;
}

// The component of v along the face's axis.
float alongFace(BoxFace face, vec3 v) {
  precise float result = select(face.ofX, v.x, select(face.ofY, v.y, v.z));
  return result;
}

vec3 faceNormal(BoxFace face) {
  precise bool ofZ = !face.ofX && !face.ofY;
  precise vec3 result =
      vec3(select(face.ofX, face.outward, 0.0f), select(face.ofY, face.outward, 0.0f),
           select(ofZ, face.outward, 0.0f));
  return result;
}

// The point is on the face exactly, and held inside the box's other slabs.
Surface boxSurface(Ray ray, float t, Box box) {
  precise BoxFace face = hitFace(ray, t, box);
  precise bool ofZ = !face.ofX && !face.ofY;
  precise bool atMaximum = face.outward > 0.0f;
  precise vec3 bound = select(atMaximum, box.maximum, box.minimum);
  precise vec3 p = pointAt(ray, t);
  precise float x = clampTo(p.x, box.minimum.x, box.maximum.x);
  precise float y = clampTo(p.y, box.minimum.y, box.maximum.y);
  precise float z = clampTo(p.z, box.minimum.z, box.maximum.z);
  precise vec3 position =
      vec3(select(face.ofX, bound.x, x), select(face.ofY, bound.y, y), select(ofZ, bound.z, z));
  precise vec3 normal = faceNormal(face);
  precise Surface result = Surface(position, normal, clearance(position, normal));
  return result;
}

// The report's box normal: axes on which the point lies within 1e-4 of a face, added and
// normalised; a point that lies near none has no normal (NaN).
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

// The point is brought to the face's plane along the face's axis, which need be neither unit nor
// orthogonal to the others; the normal is as long as that axis. The offset takes it for unit.
Surface orientedBoxSurface(Ray ray, float t, OrientedBox box) {
  precise BoxFace face = hitFace(toLocalRay(ray, box), t, toLocalBox(box));
  precise vec3 axis = select(face.ofX, box.axisX, select(face.ofY, box.axisY, box.axisZ));
  precise vec3 normal = axis * face.outward;
  precise vec3 p = pointAt(ray, t);
  precise vec3 from = p - box.center;
  precise float beyond = dot3(from, normal) - alongFace(face, box.halfSize);
  // One dot product would do, but these are constants where the box is a literal.
  precise vec3 axisSquared = vec3(dot3(box.axisX, box.axisX), dot3(box.axisY, box.axisY),
                                  dot3(box.axisZ, box.axisZ));
  precise vec3 position = p - normal * divide(beyond, alongFace(face, axisSquared));
  precise float offset = clearance(position, normal) + sizeAlong(from, normal) * kFrameScale;
  precise Surface result = Surface(position, normal, offset);
  return result;
}

Surface reportOrientedBoxSurface(Ray ray, float t, OrientedBox box) {
  precise Surface local = reportBoxSurface(toLocalRay(ray, box), t, toLocalBox(box));
  precise vec3 normal = toWorldDirection(box, local.normal);
  precise Surface result = Surface(pointAt(ray, t), normal, kReportOffset);
  return result;
}

Surface chosenOrientedBoxSurface(Ray ray, float t, OrientedBox box) {
  if (kIntersectorReport) {
    return reportOrientedBoxSurface(ray, t, box);
  }
  return orientedBoxSurface(ray, t, box);
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
  precise Surface result = Surface(position, plane.normal, clearance(position, plane.normal));
  return result;
}

Surface reportPlaneSurface(Ray ray, float t, Plane plane) {
  precise Surface result = Surface(pointAt(ray, t), plane.normal, kReportOffset);
  return result;
}

Surface chosenPlaneSurface(Ray ray, float t, Plane plane) {
  if (kIntersectorReport) {
    return reportPlaneSurface(ray, t, plane);
  }
  return planeSurface(ray, t, plane);
}

// Unit, along (b - a) x (c - a), in double since slivers have none in float; +y without an area.
vec3 triangleNormal(Triangle triangle) {
  precise dvec3 edge1 = dvec3(triangle.b) - dvec3(triangle.a);
  precise dvec3 edge2 = dvec3(triangle.c) - dvec3(triangle.a);
  precise double x = edge1.y * edge2.z - edge1.z * edge2.y;
  precise double y = edge1.z * edge2.x - edge1.x * edge2.z;
  precise double z = edge1.x * edge2.y - edge1.y * edge2.x;
  precise double squared = (x * x + y * y) + z * z;
  precise double size = sqrt(squared);
  precise double unitX = x / size;
  precise double unitY = y / size;
  precise double unitZ = z / size;
  precise vec3 unit = vec3(float(unitX), float(unitY), float(unitZ));
  precise bool hasArea = squared > 0.0f;
  precise vec3 result = select(hasArea, unit, vec3(0.0f, 1.0f, 0.0f));
  return result;
}

Surface reportTriangleSurface(Ray ray, float t, Triangle triangle) {
  precise Surface result = Surface(pointAt(ray, t), triangleNormal(triangle), kReportOffset);
  return result;
}

Surface triangleSurface(Ray ray, float t, Triangle triangle) {
  precise vec3 normal = triangleNormal(triangle);
  precise vec3 position = broughtToPlane(pointAt(ray, t), triangle.a, normal);
  precise float ab = greatest(largestCoordinate(triangle.a), largestCoordinate(triangle.b));
  precise float reach = greatest(ab, largestCoordinate(triangle.c));
  precise Surface result = Surface(position, normal, reach * kOffsetScale);
  return result;
}

Surface chosenTriangleSurface(Ray ray, float t, Triangle triangle) {
  if (kIntersectorReport) {
    return reportTriangleSurface(ray, t, triangle);
  }
  return triangleSurface(ray, t, triangle);
}

// Origin for a ray that leaves the surface along the side of `facing`, the normal or its opposite.
vec3 leavingOrigin(Surface surface, vec3 facing) {
  precise vec3 result = surface.position + facing * surface.offset;
  return result;
}
