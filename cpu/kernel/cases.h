#pragma once

// Twin of shaders/cases.glsl: tiny scenes of mixed primitives, and rays of any scale. With the robust
// intersector a case is first brought to a common scale by powers of two, which rounds nothing.

#include "cpu/kernel/path_state.h"
#include "cpu/kernel/sampling.h"
#include "cpu/kernel/surface.h"

TWINTRACE_KERNEL_BEGIN

/// The largest coordinate of a case is brought to [2^32, 2^33): see shaders/cases.glsl.
inline constexpr int kCaseExponent = 32;

/// A ray with the primitives that it sees; reach is their largest coordinate.
template <class R>
struct CaseQuery {
  Vec3<R> origin;
  Vec3<R> direction;
  R tmin;
  R tmax;
  R reach;
  int firstTexel;
  int count;
};

/// A case in the scale in which it is cast: tmin and tmax are its own, lengths are times 2^room and
/// t of the ray is times 2^shift.
template <class R>
struct CaseView {
  Ray<R> ray;
  R tmin;
  R tmax;
  int room;
  int shift;
  bool castable;
};

/// The closest hit: primitive is the index within the case, kCaseMiss or kCaseNotStarted.
template <class R>
struct CaseAnswer {
  R t;
  int primitive;
  Vec3<R> normal;
};

/// Exponent of the binary representation: -127 for zero and denormals, 128 for infinity and NaN.
template <StrictNumber R>
IntOf<R> exponentOf(R x) {
  return ((bitsOf(x) >> 23) & 255) - 127;
}

template <NativeNumber R>
std::int32_t exponentOf(R x) {
  return exponentOf(static_cast<float>(plainNumber(x)));
}

/// For exponents from -126 to 127.
template <class R>
R powerOfTwo(IntOf<R> exponent) {
  return R(floatFromBits((exponent + 127) << 23));
}

/// x 2^exponent for exponents from -252 to 254, in two steps of the same direction.
template <class R>
R scaledByPower(R x, IntOf<R> exponent) {
  const IntOf<R> first = exponent >> 1;
  const IntOf<R> second = exponent - first;
  return (x * powerOfTwo<R>(first)) * powerOfTwo<R>(second);
}

/// Exponent of the power of two that brings x >= 0 to [1, 2), or as near as such a factor can.
template <class R>
IntOf<R> shiftToOne(R x) {
  const IntOf<R> shift = 0 - exponentOf(x);
  return select(shift < -126, IntOf<R>(-126), shift);
}

/// v times the power of two that brings its largest component to [1, 2).
template <class R>
Vec3<R> broughtToOne(const Vec3<R>& v) {
  return v * powerOfTwo<R>(shiftToOne(largestCoordinate(v)));
}

template <class R>
Vec3<R> unitOf(const Vec3<R>& v) {
  return normalize3(broughtToOne(v));
}

template <class R>
MaskOf<R> isFinite(const Vec3<R>& v) {
  const R largest(kLargest);
  return absolute(v.x) <= largest && absolute(v.y) <= largest && absolute(v.z) <= largest;
}

/// All texels of a case's primitive.
template <class R>
TexelBlock<R, kCaseTexels> fetchCase(const SceneView& scene, int texel) {
  return fetchRecord<R, kCaseTexels>(scene, texel, kCaseTexels, 0, 1);
}

inline int caseKind(const SceneView& scene, int texel) {
  return fetchCase<float>(scene, texel).integer(0, 3);
}

template <class R>
Sphere<R> fetchCaseSphere(const SceneView& scene, int texel, R scale) {
  const auto block = fetchCase<R>(scene, texel);
  return {block.floats3(0) * scale, block.number(1, 0) * scale};
}

template <class R>
Box<R> fetchCaseBox(const SceneView& scene, int texel, R scale) {
  const auto block = fetchCase<R>(scene, texel);
  return {block.floats3(0) * scale, block.floats3(1) * scale};
}

template <class R>
OrientedBox<R> fetchCaseOrientedBox(const SceneView& scene, int texel, R scale) {
  const auto block = fetchCase<R>(scene, texel);
  const Vec3<R> halfSize(block.float4th(1), block.float4th(2), block.float4th(3));
  return {block.floats3(0) * scale, block.floats3(1), block.floats3(2), block.floats3(3),
          halfSize * scale};
}

/// The normal's length does not matter to the robust intersector; the report's compares with it.
template <class R>
Plane<R> fetchCasePlane(const SceneView& scene, int texel, R scale) {
  const auto block = fetchCase<R>(scene, texel);
  const Vec3<R> normal = block.floats3(0);
  return {block.floats3(1) * scale, scene.intersectorReport ? normal : broughtToOne(normal)};
}

template <class R>
Triangle<R> fetchCaseTriangle(const SceneView& scene, int texel, R scale) {
  const auto block = fetchCase<R>(scene, texel);
  return {block.floats3(0) * scale, block.floats3(1) * scale, block.floats3(2) * scale};
}

/// Distance to the primitive of a case, or infinity.
template <class R>
R intersectCase(const SceneView& scene, const Ray<R>& ray, int texel, R scale) {
  switch (caseKind(scene, texel)) {
    case kCaseSphere:
      return intersectSphere(scene, ray, fetchCaseSphere<R>(scene, texel, scale));
    case kCaseBox:
      return intersectBox(scene, ray, fetchCaseBox<R>(scene, texel, scale));
    case kCaseOrientedBox:
      return intersectOrientedBox(scene, ray, fetchCaseOrientedBox<R>(scene, texel, scale));
    case kCasePlane:
      return intersectPlane(scene, ray, fetchCasePlane<R>(scene, texel, scale));
    default:
      return intersectTriangle(scene, ray, fetchCaseTriangle<R>(scene, texel, scale));
  }
}

/// Smallest t within the ray's closed interval, ties to the first primitive.
template <class R>
Hit<R> castCase(const SceneView& scene, const Ray<R>& ray, int firstTexel, int count, R scale) {
  Hit<R> best{ray.tmax, IntOf<R>(kNoPrimitive)};
  for (int i = 0; i < count; ++i) {
    const R t = intersectCase(scene, ray, firstTexel + i * kCaseTexels, scale);
    best = nearer(best, t, IntOf<R>(i));
  }
  return best;
}

/// The plane as its surface needs it: its normal's length is whatever was written.
template <class R>
Plane<R> withUnitNormal(const Plane<R>& plane) {
  return {plane.point, unitOf(plane.normal)};
}

/// An oriented box's axes are unit only to within rounding, or whatever was written.
template <class R>
Surface<R> orientedCaseSurface(const SceneView& scene, const Ray<R>& ray, R t,
                               const OrientedBox<R>& box) {
  Surface<R> surface = chosenOrientedBoxSurface(scene, ray, t, box);
  surface.normal = unitOf(surface.normal);
  return surface;
}

/// The surface of a case's primitive at a hit.
template <class R>
Surface<R> caseSurface(const SceneView& scene, const Ray<R>& ray, R t, int texel, R scale) {
  switch (caseKind(scene, texel)) {
    case kCaseSphere:
      return chosenSphereSurface(scene, ray, t, fetchCaseSphere<R>(scene, texel, scale));
    case kCaseBox:
      return chosenBoxSurface(scene, ray, t, fetchCaseBox<R>(scene, texel, scale));
    case kCaseOrientedBox:
      return orientedCaseSurface(scene, ray, t, fetchCaseOrientedBox<R>(scene, texel, scale));
    case kCasePlane:
      return chosenPlaneSurface(scene, ray, t,
                                withUnitNormal(fetchCasePlane<R>(scene, texel, scale)));
    default:
      return chosenTriangleSurface(scene, ray, t, fetchCaseTriangle<R>(scene, texel, scale));
  }
}

/// tmin in the scale of the view; one that is lost to underflow is still above zero.
template <class R>
R scaledStart(R tmin, IntOf<R> shift) {
  const R scaled = scaledByPower(tmin, shift);
  const MaskOf<R> lost = tmin > R(0.0f) && scaled == R(0.0f);
  return select(lost, powerOfTwo<R>(-126), scaled);
}

/// The ray from an origin in the scale 2^room along a direction, over the interval that is tmin to
/// tmax in the case's own units.
template <class R>
CaseView<R> viewRay(const Vec3<R>& origin, const Vec3<R>& direction, R tmin, R tmax, int room,
                    int shift) {
  const R end = least(R(kLargest), tmax);
  const R scaledEnd = least(R(kLargest), scaledByPower(end, shift));
  const Ray<R> ray = makeRay(origin, direction, scaledStart(tmin, shift), scaledEnd);
  const bool moves = largestCoordinate(direction) > R(0.0f);
  const bool castable = isFinite(origin) && isFinite(direction) && moves && tmin <= tmax;
  return {ray, tmin, end, room, shift, castable};
}

template <class R>
CaseView<R> viewCase(const SceneView& scene, const CaseQuery<R>& query) {
  const R reach = greatest(query.reach, largestCoordinate(query.origin));
  const int wanted = shiftToOne(reach) + kCaseExponent;
  int room = select(wanted < 126, wanted, 126);
  int aim = shiftToOne(largestCoordinate(query.direction));
  if (scene.intersectorReport) {
    room = 0;
    aim = 0;
  }
  return viewRay(query.origin * powerOfTwo<R>(room), query.direction * powerOfTwo<R>(aim),
                 query.tmin, query.tmax, room, room - aim);
}

/// The closest hit whose distance in the case's own units lies in the interval too.
template <class R>
Hit<R> hitInView(const SceneView& scene, const CaseView<R>& view, int firstTexel, int count) {
  Hit<R> hit{R(0.0f), kNoPrimitive};
  if (view.castable) {
    hit = castCase(scene, view.ray, firstTexel, count, powerOfTwo<R>(view.room));
  }
  const R t = scaledByPower(hit.t, 0 - view.shift);
  const bool outside = t < view.tmin || t > view.tmax;
  if (outside) hit.primitive = kNoPrimitive;
  return hit;
}

template <class R>
Surface<R> surfaceInView(const SceneView& scene, const CaseView<R>& view, const Hit<R>& hit,
                         int firstTexel) {
  return caseSurface(scene, view.ray, hit.t, firstTexel + hit.primitive * kCaseTexels,
                     powerOfTwo<R>(view.room));
}

/// The hit in the case's own units.
template <class R>
CaseAnswer<R> answerInView(const SceneView& scene, const CaseView<R>& view, const Hit<R>& hit,
                           int firstTexel) {
  if (hit.primitive == kNoPrimitive) return {R(0.0f), kCaseMiss, Vec3<R>()};
  return {scaledByPower(hit.t, 0 - view.shift), hit.primitive,
          surfaceInView(scene, view, hit, firstTexel).normal};
}

template <class R>
CaseAnswer<R> castQuery(const SceneView& scene, const CaseQuery<R>& query) {
  const CaseView<R> view = viewCase(scene, query);
  const Hit<R> hit = hitInView(scene, view, query.firstTexel, query.count);
  return answerInView(scene, view, hit, query.firstTexel);
}

/// The ray that leaves a hit as a path's does, into the cosine-weighted direction of u and v, over
/// [0, largest float].
template <class R>
CaseView<R> bounceInView(const SceneView& scene, const CaseView<R>& view, const Hit<R>& hit,
                         int firstTexel, R u, R v) {
  const Surface<R> surface = surfaceInView(scene, view, hit, firstTexel);
  const Vec3<R> facing = facingNormal(surface.normal, view.ray.direction);
  const Vec3<R> direction = tangentToWorld(facing, sampleCosineHemisphere(u, v));
  return viewRay(leavingOrigin(surface, facing), direction, R(0.0f), R(kLargest), view.room,
                 view.room);
}

/// The second hit, of the ray that leaves the first one.
template <class R>
CaseAnswer<R> castBounce(const SceneView& scene, const CaseQuery<R>& query, R u, R v) {
  const CaseView<R> view = viewCase(scene, query);
  const Hit<R> hit = hitInView(scene, view, query.firstTexel, query.count);
  if (hit.primitive == kNoPrimitive) return {R(0.0f), kCaseNotStarted, Vec3<R>()};
  const CaseView<R> next = bounceInView(scene, view, hit, query.firstTexel, u, v);
  const Hit<R> second = hitInView(scene, next, query.firstTexel, query.count);
  return answerInView(scene, next, second, query.firstTexel);
}

TWINTRACE_KERNEL_END
