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
inline constexpr float kPlaneOffsetScale = 1.5e-7f;
/// Parts an origin from a plane through the scene's origin: see shaders/surface.glsl.
inline constexpr float kLeastOffset = 1e-30f;
/// A tangent's least step, in radii, from the nearest point to its hit: see shaders/surface.glsl.
inline constexpr float kLeastAside = 0x1p-20f;
/// The report's fixed offset, in scene units.
inline constexpr float kReportOffset = 1e-4f;

template <class R>
R largestCoordinate(const Vec3<R>& v) {
  return largestComponent(Vec3<R>(absolute(v.x), absolute(v.y), absolute(v.z)));
}

/// Outward and unit, at the entry or exit that is closest to t: rounding may put the point at t
/// itself anywhere in a small and far sphere, or outside. +y without a hit.
template <class R>
Vec3<R> sphereNormal(const Ray<R>& ray, R t, const Sphere<R>& sphere) {
  const SphereLine<R> line = lineThrough(ray, sphere);
  const SphereChord<R> chord = chordOf(line, sphere.radius);
  const MaskOf<R> entering = chord.entry >= ray.tmin && t - chord.entry <= chord.exit - t;
  const R aside = greatest(chord.aside, R(kLeastAside));
  const Vec3<R> unit = line.nearest + ray.direction * select(entering, -aside, aside);
  return select(line.squared >= R(0.0f), unit, Vec3<R>(R(0.0f), R(1.0f), R(0.0f)));
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

/// How far the best face's plane is from being the one that was hit, and its normal.
template <class R>
struct FaceChoice {
  R error;
  Vec3<R> normal;
};

template <class R>
FaceChoice<R> closerFace(const FaceChoice<R>& best, R t, R planeT, const Vec3<R>& normal) {
  const R error = absolute(planeT - t);
  const MaskOf<R> better = error < best.error;
  return {select(better, error, best.error), select(better, normal, best.normal)};
}

/// The face whose plane distance, computed as in intersectBoxRobust, is t; of two that coincide the
/// near one.
template <class R>
FaceChoice<R> hitFace(const Ray<R>& ray, R t, const Box<R>& box) {
  const R zero(0.0f);
  const R one(1.0f);
  const MaskOf<R> backX = ray.direction.x < zero;
  const MaskOf<R> backY = ray.direction.y < zero;
  const MaskOf<R> backZ = ray.direction.z < zero;
  const R x = select(backX, one, -one);
  const R y = select(backY, one, -one);
  const R z = select(backZ, one, -one);
  const Vec3<R> low = (box.minimum - ray.origin) * ray.inverse;
  const Vec3<R> high = (box.maximum - ray.origin) * ray.inverse;
  FaceChoice<R> best{R(kInfinity), Vec3<R>(zero, one, zero)};
  best = closerFace(best, t, select(backX, high.x, low.x), Vec3<R>(x, zero, zero));
  best = closerFace(best, t, select(backY, high.y, low.y), Vec3<R>(zero, y, zero));
  best = closerFace(best, t, select(backZ, high.z, low.z), Vec3<R>(zero, zero, z));
  best = closerFace(best, t, select(backX, low.x, high.x), Vec3<R>(-x, zero, zero));
  best = closerFace(best, t, select(backY, low.y, high.y), Vec3<R>(zero, -y, zero));
  best = closerFace(best, t, select(backZ, low.z, high.z), Vec3<R>(zero, zero, -z));
  return best;
}

/// The coordinate on the hit face: the bound on the face's axis, held inside the box on the others.
template <class R>
R snapToFace(R x, R low, R high, R outward) {
  const R held = clampTo(x, low, high);
  const R lowOrHeld = select(outward < R(0.0f), low, held);
  return select(outward > R(0.0f), high, lowOrHeld);
}

template <class R>
Surface<R> boxSurface(const Ray<R>& ray, R t, const Box<R>& box) {
  const Vec3<R> normal = hitFace(ray, t, box).normal;
  const Vec3<R> p = pointAt(ray, t);
  const Vec3<R> position(snapToFace(p.x, box.minimum.x, box.maximum.x, normal.x),
                         snapToFace(p.y, box.minimum.y, box.maximum.y, normal.y),
                         snapToFace(p.z, box.minimum.z, box.maximum.z, normal.z));
  const R low = largestCoordinate(box.minimum);
  const R offset = greatest(low, largestCoordinate(box.maximum)) * errorBound<R>(kOffsetScale);
  return {position, normal, offset};
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

/// The point is brought to the slab's plane along the slab's axis, which need be neither unit nor
/// orthogonal to the others; the normal is as long as that axis.
template <class R>
Surface<R> orientedBoxSurface(const SceneView& scene, const Ray<R>& ray, R t,
                              const OrientedBox<R>& box) {
  const Surface<R> local = chosenBoxSurface(scene, toLocalRay(ray, box), t, toLocalBox(box));
  const Vec3<R> normal = toWorldDirection(box, local.normal);
  const Vec3<R> p = pointAt(ray, t);
  const Vec3<R> from = p - box.center;
  const R beyond = dot3(from, normal) - dot3(local.normal * local.normal, box.halfSize);
  const Vec3<R> position = p - normal * divide(beyond, dot3(normal, normal));
  const R reach = greatest(largestCoordinate(position), largestCoordinate(box.center));
  const R scaled = reach * errorBound<R>(kOffsetScale);
  const R offset = scene.intersectorReport ? R(kReportOffset) : scaled;
  return {position, normal, offset};
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
  const Vec3<R> along = position * plane.normal;
  const R rounding = (absolute(along.x) + absolute(along.y)) + absolute(along.z);
  const R offset = rounding * errorBound<R>(kPlaneOffsetScale) + R(kLeastOffset);
  return {position, plane.normal, offset};
}

template <class R>
Surface<R> chosenSurface(MaskOf<R> condition, const Surface<R>& a, const Surface<R>& b) {
  return {select(condition, a.position, b.position), select(condition, a.normal, b.normal),
          select(condition, a.offset, b.offset)};
}

/// The surface at a hit; for a miss, some surface without meaning.
template <class R>
Surface<R> surfaceAt(const SceneView& scene, const Ray<R>& ray, const Hit<R>& hit) {
  using Int = IntOf<R>;
  using Mask = MaskOf<R>;
  const SceneIndex& index = scene.index;
  Surface<R> result{Vec3<R>(), Vec3<R>(R(0.0f), R(1.0f), R(0.0f)), R(0.0f)};
  int first = 0;
  if (scene.effectSphere) {
    const Mask here = hit.primitive < Int(index.sphereCount);
    if (anyLane(here)) {
      const Sphere<R> sphere = visitedSphere<R>(scene, select(here, hit.primitive, Int(0)));
      result = chosenSurface(here, chosenSphereSurface(scene, ray, hit.t, sphere), result);
    }
  }
  first += index.sphereCount;
  if (scene.effectBox) {
    const Mask here =
        hit.primitive >= Int(first) && hit.primitive < Int(first + index.boxCount);
    if (anyLane(here)) {
      const Box<R> box = visitedBox<R>(scene, select(here, hit.primitive - Int(first), Int(0)));
      result = chosenSurface(here, chosenBoxSurface(scene, ray, hit.t, box), result);
    }
  }
  first += index.boxCount;
  if (scene.effectOrientedBox) {
    const Mask here =
        hit.primitive >= Int(first) && hit.primitive < Int(first + index.orientedBoxCount);
    if (anyLane(here)) {
      const OrientedBox<R> box =
          visitedOrientedBox<R>(scene, select(here, hit.primitive - Int(first), Int(0)));
      result = chosenSurface(here, orientedBoxSurface(scene, ray, hit.t, box), result);
    }
  }
  first += index.orientedBoxCount;
  if (scene.effectPlane) {
    const Mask here =
        hit.primitive >= Int(first) && hit.primitive < Int(first + index.planeCount);
    if (anyLane(here)) {
      const Plane<R> plane = visitedPlane<R>(scene, select(here, hit.primitive - Int(first), Int(0)));
      result = chosenSurface(here, planeSurface(ray, hit.t, plane), result);
    }
  }
  if (scene.intersectorReport) {
    result.position = pointAt(ray, hit.t);
    result.offset = R(kReportOffset);
  }
  return result;
}

/// Origin for a ray that leaves the surface along the side of `facing`, the normal or its opposite.
template <class R>
Vec3<R> leavingOrigin(const Surface<R>& surface, const Vec3<R>& facing) {
  return surface.position + facing * surface.offset;
}

TWINTRACE_KERNEL_END
