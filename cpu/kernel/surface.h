#pragma once

// Twin of shaders/surface.glsl: the surface at a hit.

#include "cpu/kernel/geometry.h"

TWINTRACE_KERNEL_BEGIN

/// A point that lies on the surface to within a few ulp, its unit normal, and how far along the
/// normal a new ray's origin must move to have left it.
template <class R>
struct Surface {
  Vec3<R> position;
  Vec3<R> normal;
  R offset;
};

/// 12 units of 2^-24: see shaders/surface.glsl.
inline constexpr float kOffsetScale = 7.2e-7f;
/// 2.5 units of 2^-24: see shaders/surface.glsl.
inline constexpr float kClearanceScale = 1.5e-7f;
/// Parts an origin from a surface at the scene's origin: see shaders/surface.glsl.
inline constexpr float kLeastClearance = 1e-30f;
/// 8.5 units of 2^-24: see shaders/surface.glsl.
inline constexpr float kFrameScale = 5.1e-7f;
/// A tangent's least step, in radii, from the nearest point to its hit: see shaders/surface.glsl.
inline constexpr float kLeastHalfChord = 0x1p-20f;
/// The report's fixed offset, in scene units.
inline constexpr float kReportOffset = 1e-4f;

template <class R>
R largestCoordinate(const Vec3<R>& v) {
  return largestComponent(Vec3<R>(absolute(v.x), absolute(v.y), absolute(v.z)));
}

/// The sizes of the products in v . normal, added up.
template <class R>
R sizeAlong(const Vec3<R>& v, const Vec3<R>& normal) {
  const Vec3<R> along = v * normal;
  return (absolute(along.x) + absolute(along.y)) + absolute(along.z);
}

/// Offset of a point off which only its coordinates' rounding can move an origin.
template <class R>
R clearance(const Vec3<R>& position, const Vec3<R>& normal) {
  return sizeAlong(position, normal) * errorBound<R>(kClearanceScale) + R(kLeastClearance);
}

/// Outward and unit, at the entry or exit that is closest to t: rounding may put the point at t
/// itself anywhere in a small and far sphere, or outside. Without meaning for a miss.
template <class R>
Vec3<R> sphereNormal(const Ray<R>& ray, R t, const Sphere<R>& sphere) {
  const SphereLine<R> line = sphereLineOf(ray, sphere);
  const SphereChord<R> chord = chordOf(line, sphere.radius);
  const MaskOf<R> entering = chord.entry >= ray.tmin && t - chord.entry <= chord.exit - t;
  const R halfChord = greatest(R(kLeastHalfChord), chord.halfChord);
  return line.nearest + ray.direction * select(entering, -halfChord, halfChord);
}

template <class R>
Surface<R> sphereSurface(const Ray<R>& ray, R t, const Sphere<R>& sphere) {
  const Vec3<R> outward = sphereNormal(ray, t, sphere);
  const Vec3<R> position = sphere.center + outward * sphere.radius;
  const R offset = (largestCoordinate(sphere.center) + sphere.radius) * errorBound<R>(kOffsetScale);
  return {position, outward, offset};
}

/// The report's normal is that of the point at t, wherever it lies.
template <class R>
Surface<R> reportSphereSurface(const Ray<R>& ray, R t, const Sphere<R>& sphere) {
  const Vec3<R> p = pointAt(ray, t);
  return {p, normalize3(p - sphere.center), R(kReportOffset)};
}

template <class R>
Surface<R> chosenSphereSurface(const SceneView& scene, const Ray<R>& ray, R t,
                               const Sphere<R>& sphere) {
  if (scene.intersectorReport) return reportSphereSurface(ray, t, sphere);
  return sphereSurface(ray, t, sphere);
}

/// A face of a box: of its z slab if of neither other, and the side on which its outside lies, -1
/// or 1.
template <class R>
struct BoxFace {
  MaskOf<R> ofX;
  MaskOf<R> ofY;
  R outward;
};

/// The face by which the ray enters or leaves, whichever is closer to t; of two that coincide the
/// one by which it enters. Some face for a miss.
template <class R>
BoxFace<R> hitFace(const Ray<R>& ray, R t, const Box<R>& box) {
  const Slabs<R> slabs = slabsOf(ray, box);
  const MaskOf<R> entering =
      slabs.entry >= ray.tmin && t - slabs.entry <= absolute(slabs.exit - t);
  const R bound = select(entering, slabs.entry, slabs.exit);
  const MaskOf<R> ofX = select(entering, slabs.near.x, slabs.far.x) == bound;
  const MaskOf<R> ofY = !ofX && select(entering, slabs.near.y, slabs.far.y) == bound;
  const R along = select(ofX, ray.direction.x, select(ofY, ray.direction.y, ray.direction.z));
  const MaskOf<R> toMinimum = (along < R(0.0f)) != entering;
  return {ofX, ofY, select(toMinimum, R(-1.0f), R(1.0f))};
}

/// The component of v along the face's axis.
template <class R>
R alongFace(const BoxFace<R>& face, const Vec3<R>& v) {
  return select(face.ofX, v.x, select(face.ofY, v.y, v.z));
}

template <class R>
Vec3<R> faceNormal(const BoxFace<R>& face) {
  const R zero(0.0f);
  const MaskOf<R> ofZ = !face.ofX && !face.ofY;
  return Vec3<R>(select(face.ofX, face.outward, zero), select(face.ofY, face.outward, zero),
                 select(ofZ, face.outward, zero));
}

/// The point is on the face exactly, and held inside the box's other slabs.
template <class R>
Surface<R> boxSurface(const Ray<R>& ray, R t, const Box<R>& box) {
  const BoxFace<R> face = hitFace(ray, t, box);
  const MaskOf<R> ofZ = !face.ofX && !face.ofY;
  const Vec3<R> bound = select(face.outward > R(0.0f), box.maximum, box.minimum);
  const Vec3<R> p = pointAt(ray, t);
  const R x = clampTo(p.x, box.minimum.x, box.maximum.x);
  const R y = clampTo(p.y, box.minimum.y, box.maximum.y);
  const R z = clampTo(p.z, box.minimum.z, box.maximum.z);
  const Vec3<R> position(select(face.ofX, bound.x, x), select(face.ofY, bound.y, y),
                         select(ofZ, bound.z, z));
  const Vec3<R> normal = faceNormal(face);
  return {position, normal, clearance(position, normal)};
}

/// The report's box normal: axes on which the point lies within 1e-4 of a face, added and
/// normalised; NaN near none.
template <class R>
Vec3<R> reportBoxNormal(const Vec3<R>& p, const Vec3<R>& center, const Vec3<R>& halfSize) {
  const R zero(0.0f);
  const R one(1.0f);
  const Vec3<R> from = p - center;
  const R gapX = absolute(absolute(from.x) - halfSize.x);
  const R gapY = absolute(absolute(from.y) - halfSize.y);
  const R gapZ = absolute(absolute(from.z) - halfSize.z);
  const R x = select(gapX < R(1e-4f), select(from.x < zero, -one, one), zero);
  const R y = select(gapY < R(1e-4f), select(from.y < zero, -one, one), zero);
  const R z = select(gapZ < R(1e-4f), select(from.z < zero, -one, one), zero);
  return normalize3(Vec3<R>(x, y, z));
}

template <class R>
Surface<R> reportBoxSurface(const Ray<R>& ray, R t, const Box<R>& box) {
  const Vec3<R> p = pointAt(ray, t);
  const Vec3<R> center = (box.minimum + box.maximum) * R(0.5f);
  const Vec3<R> halfSize = (box.maximum - box.minimum) * R(0.5f);
  return {p, reportBoxNormal(p, center, halfSize), R(kReportOffset)};
}

template <class R>
Surface<R> chosenBoxSurface(const SceneView& scene, const Ray<R>& ray, R t, const Box<R>& box) {
  if (scene.intersectorReport) return reportBoxSurface(ray, t, box);
  return boxSurface(ray, t, box);
}

/// The point is brought to the face's plane along the face's axis, which need be neither unit nor
/// orthogonal to the others; the normal is as long as that axis. The offset takes it for unit.
template <class R>
Surface<R> orientedBoxSurface(const Ray<R>& ray, R t, const OrientedBox<R>& box) {
  const BoxFace<R> face = hitFace(toLocalRay(ray, box), t, toLocalBox(box));
  const Vec3<R> axis = select(face.ofX, box.axisX, select(face.ofY, box.axisY, box.axisZ));
  const Vec3<R> normal = axis * face.outward;
  const Vec3<R> p = pointAt(ray, t);
  const Vec3<R> from = p - box.center;
  const R beyond = dot3(from, normal) - alongFace(face, box.halfSize);
  const Vec3<R> axisSquared(dot3(box.axisX, box.axisX), dot3(box.axisY, box.axisY),
                            dot3(box.axisZ, box.axisZ));
  const Vec3<R> position = p - normal * divide(beyond, alongFace(face, axisSquared));
  const R offset =
      clearance(position, normal) + sizeAlong(from, normal) * errorBound<R>(kFrameScale);
  return {position, normal, offset};
}

template <class R>
Surface<R> reportOrientedBoxSurface(const Ray<R>& ray, R t, const OrientedBox<R>& box) {
  const Surface<R> local = reportBoxSurface(toLocalRay(ray, box), t, toLocalBox(box));
  return {pointAt(ray, t), toWorldDirection(box, local.normal), R(kReportOffset)};
}

template <class R>
Surface<R> chosenOrientedBoxSurface(const SceneView& scene, const Ray<R>& ray, R t,
                                    const OrientedBox<R>& box) {
  if (scene.intersectorReport) return reportOrientedBoxSurface(ray, t, box);
  return orientedBoxSurface(ray, t, box);
}

/// p moved along the unit normal onto the plane through `point`.
template <class R>
Vec3<R> broughtToPlane(const Vec3<R>& p, const Vec3<R>& point, const Vec3<R>& normal) {
  using Wider = WiderOf<R>;
  const Vec3<Wider> n = wider3(normal);
  const Vec3<Wider> from = wider3(p) - wider3(point);
  const Wider height = (from.x * n.x + from.y * n.y) + from.z * n.z;
  const Vec3<Wider> moved = wider3(p) - n * height;
  return {rounded<R>(moved.x), rounded<R>(moved.y), rounded<R>(moved.z)};
}

template <class R>
Surface<R> planeSurface(const Ray<R>& ray, R t, const Plane<R>& plane) {
  const Vec3<R> position = broughtToPlane(pointAt(ray, t), plane.point, plane.normal);
  return {position, plane.normal, clearance(position, plane.normal)};
}

template <class R>
Surface<R> reportPlaneSurface(const Ray<R>& ray, R t, const Plane<R>& plane) {
  return {pointAt(ray, t), plane.normal, R(kReportOffset)};
}

template <class R>
Surface<R> chosenPlaneSurface(const SceneView& scene, const Ray<R>& ray, R t,
                              const Plane<R>& plane) {
  if (scene.intersectorReport) return reportPlaneSurface(ray, t, plane);
  return planeSurface(ray, t, plane);
}

/// Unit, along (b - a) x (c - a), in double since slivers have none in float; +y without an area.
template <class R>
Vec3<R> triangleNormal(const Triangle<R>& triangle) {
  using Wider = WiderOf<R>;
  const Vec3<Wider> edge1 = wider3(triangle.b) - wider3(triangle.a);
  const Vec3<Wider> edge2 = wider3(triangle.c) - wider3(triangle.a);
  const Wider x = edge1.y * edge2.z - edge1.z * edge2.y;
  const Wider y = edge1.z * edge2.x - edge1.x * edge2.z;
  const Wider z = edge1.x * edge2.y - edge1.y * edge2.x;
  const Wider squared = (x * x + y * y) + z * z;
  const Wider size = rootOf(squared);
  const Vec3<R> unit(rounded<R>(x / size), rounded<R>(y / size), rounded<R>(z / size));
  const MaskOf<R> hasArea = squared > Wider(0.0f);
  return select(hasArea, unit, Vec3<R>(R(0.0f), R(1.0f), R(0.0f)));
}

template <class R>
Surface<R> reportTriangleSurface(const Ray<R>& ray, R t, const Triangle<R>& triangle) {
  return {pointAt(ray, t), triangleNormal(triangle), R(kReportOffset)};
}

template <class R>
Surface<R> triangleSurface(const Ray<R>& ray, R t, const Triangle<R>& triangle) {
  const Vec3<R> normal = triangleNormal(triangle);
  const Vec3<R> position = broughtToPlane(pointAt(ray, t), triangle.a, normal);
  const R ab = greatest(largestCoordinate(triangle.a), largestCoordinate(triangle.b));
  const R reach = greatest(ab, largestCoordinate(triangle.c));
  return {position, normal, reach * errorBound<R>(kOffsetScale)};
}

template <class R>
Surface<R> chosenTriangleSurface(const SceneView& scene, const Ray<R>& ray, R t,
                                 const Triangle<R>& triangle) {
  if (scene.intersectorReport) return reportTriangleSurface(ray, t, triangle);
  return triangleSurface(ray, t, triangle);
}

/// Origin for a ray that leaves the surface along the side of `facing`, the normal or its opposite.
template <class R>
Vec3<R> leavingOrigin(const Surface<R>& surface, const Vec3<R>& facing) {
  return surface.position + facing * surface.offset;
}

TWINTRACE_KERNEL_END
