#pragma once

// Twin of shaders/surface.glsl: the surface at a hit.

#include "cpu/kernel/intersect.h"
#include "cpu/kernel/scene_access.h"

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
/// The report's fixed offset, in scene units.
inline constexpr float kReportOffset = 1e-4f;

template <class R>
R largestCoordinate(const Vec3<R>& v) {
  return largestComponent(Vec3<R>(absolute(v.x), absolute(v.y), absolute(v.z)));
}

template <class R>
Surface<R> sphereSurface(const Ray<R>& ray, R t, const Sphere<R>& sphere) {
  const Vec3<R> outward = normalize3(pointAt(ray, t) - sphere.center);
  const Vec3<R> position = sphere.center + outward * sphere.radius;
  const R offset = (largestCoordinate(sphere.center) + sphere.radius) * errorBound<R>(kOffsetScale);
  return {position, outward, offset};
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

/// The face whose plane distance, computed as in intersectBoxRobust, is t.
template <class R>
FaceChoice<R> hitFace(const Ray<R>& ray, R t, const Box<R>& box) {
  const R zero(0.0f);
  const R one(1.0f);
  const Vec3<R> low = (box.minimum - ray.origin) * ray.inverse;
  const Vec3<R> high = (box.maximum - ray.origin) * ray.inverse;
  FaceChoice<R> best{R(kInfinity), Vec3<R>(zero, one, zero)};
  best = closerFace(best, t, low.x, Vec3<R>(-one, zero, zero));
  best = closerFace(best, t, low.y, Vec3<R>(zero, -one, zero));
  best = closerFace(best, t, low.z, Vec3<R>(zero, zero, -one));
  best = closerFace(best, t, high.x, Vec3<R>(one, zero, zero));
  best = closerFace(best, t, high.y, Vec3<R>(zero, one, zero));
  best = closerFace(best, t, high.z, Vec3<R>(zero, zero, one));
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

template <class R>
Surface<R> orientedBoxSurface(const SceneView& scene, const Ray<R>& ray, R t,
                              const OrientedBox<R>& box) {
  const Surface<R> local = chosenBoxSurface(scene, toLocalRay(ray, box), t, toLocalBox(box));
  const Vec3<R> position = box.center + toWorldDirection(box, local.position);
  const Vec3<R> normal = toWorldDirection(box, local.normal);
  // The axes are rounded to float, so the way there and back errs by that in double too.
  const R reach = largestCoordinate(box.center) + largestCoordinate(box.halfSize) * R(2.0f);
  const R offset = scene.intersectorReport ? R(kReportOffset) : reach * R(kOffsetScale);
  return {position, normal, offset};
}

template <class R>
Surface<R> planeSurface(const Ray<R>& ray, R t, const Plane<R>& plane) {
  const Vec3<R> p = pointAt(ray, t);
  const Vec3<R> position = p - plane.normal * dot3(p - plane.point, plane.normal);
  const R reach = greatest(largestCoordinate(position), largestCoordinate(plane.point));
  return {position, plane.normal, reach * errorBound<R>(kOffsetScale)};
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
      const Sphere<R> sphere = fetchSphere<R>(scene, select(here, hit.primitive, Int(0)));
      result = chosenSurface(here, sphereSurface(ray, hit.t, sphere), result);
    }
  }
  first += index.sphereCount;
  if (scene.effectBox) {
    const Mask here =
        hit.primitive >= Int(first) && hit.primitive < Int(first + index.boxCount);
    if (anyLane(here)) {
      const Box<R> box = fetchBox<R>(scene, select(here, hit.primitive - Int(first), Int(0)));
      result = chosenSurface(here, chosenBoxSurface(scene, ray, hit.t, box), result);
    }
  }
  first += index.boxCount;
  if (scene.effectOrientedBox) {
    const Mask here =
        hit.primitive >= Int(first) && hit.primitive < Int(first + index.orientedBoxCount);
    if (anyLane(here)) {
      const OrientedBox<R> box =
          fetchOrientedBox<R>(scene, select(here, hit.primitive - Int(first), Int(0)));
      result = chosenSurface(here, orientedBoxSurface(scene, ray, hit.t, box), result);
    }
  }
  first += index.orientedBoxCount;
  if (scene.effectPlane) {
    const Mask here =
        hit.primitive >= Int(first) && hit.primitive < Int(first + index.planeCount);
    if (anyLane(here)) {
      const Plane<R> plane = fetchPlane<R>(scene, select(here, hit.primitive - Int(first), Int(0)));
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
