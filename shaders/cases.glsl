// Cases: tiny scenes of mixed primitives, each a range of texels, and rays of any scale.
//
// With the robust intersector a case is first brought to a common scale by powers of two, which
// rounds nothing: so lengths and directions whose squares are no floats are no worse than others.
// The report's intersector gets the case as it is.
#pragma once

#include "path_state.glsl"
#include "sampling.glsl"
#include "surface.glsl"

// The largest coordinate of a case is brought to [2^32, 2^33). Products of three differences of such
// coordinates stay below the largest float, and squares of lengths 2^95 times smaller above the
// smallest normal one.
const int kCaseExponent = 32;

// A ray with the primitives that it sees.
struct CaseQuery {
  vec3 origin;
  vec3 direction;
  float tmin;
  float tmax;
  float reach;  // largest coordinate of the primitives
  int firstTexel;
  int count;
};

// A case in the scale in which it is cast.
struct CaseView {
  Ray ray;
  float tmin;  // the interval in the case's own units
  float tmax;
  int room;    // lengths are the case's times 2^room
  int shift;   // and t of the ray is the case's times 2^shift
  bool castable;
};

// The closest hit; t and normal have no meaning without one.
struct CaseAnswer {
  float t;
  int primitive;  // index within the case, kCaseMiss or kCaseNotStarted
  vec3 normal;    // unit
};

// Exponent of the binary representation: -127 for zero and denormals, 128 for infinity and NaN.
int exponentOf(float x) {
  int bits = floatBitsToInt(x);
  return ((bits >> 23) & 255) - 127;
}

// For exponents from -126 to 127.
float powerOfTwo(int exponent) {
  precise float result = intBitsToFloat((exponent + 127) << 23);
  return result;
}

// x 2^exponent for exponents from -252 to 254. Two steps, since one factor may be no float; both go
// the same way, so that neither overflows where the result does not.
float scaledByPower(float x, int exponent) {
  int first = exponent >> 1;
  int second = exponent - first;
  precise float once = x * powerOfTwo(first);
  precise float result = once * powerOfTwo(second);
  return result;
}

// Exponent of the power of two that brings x >= 0 to [1, 2), or as near as such a factor can.
int shiftToOne(float x) {
  int shift = 0 - exponentOf(x);
  return select(shift < -126, -126, shift);
}

// v times the power of two that brings its largest component to [1, 2).
vec3 broughtToOne(vec3 v) {
  precise vec3 result = v * powerOfTwo(shiftToOne(largestCoordinate(v)));
  return result;
}

vec3 unitOf(vec3 v) {
  precise vec3 result = normalize3(broughtToOne(v));
  return result;
}

bool isFinite(vec3 v) {
  precise bool x = absolute(v.x) <= kLargest;
  precise bool y = absolute(v.y) <= kLargest;
  precise bool z = absolute(v.z) <= kLargest;
  return x && y && z;
}

int caseKind(int texel) {
  return int(fetchTexel(texel).w);
}

Sphere fetchCaseSphere(int texel, float scale) {
  precise vec3 center = floats3(fetchTexel(texel)) * scale;
  precise float radius = floats3(fetchTexel(texel + 1)).x * scale;
  precise Sphere result = Sphere(center, radius);
  return result;
}

Box fetchCaseBox(int texel, float scale) {
  precise vec3 minimum = floats3(fetchTexel(texel)) * scale;
  precise vec3 maximum = floats3(fetchTexel(texel + 1)) * scale;
  precise Box result = Box(minimum, maximum);
  return result;
}

OrientedBox fetchCaseOrientedBox(int texel, float scale) {
  precise vec3 center = floats3(fetchTexel(texel)) * scale;
  precise vec3 given = vec3(float4th(fetchTexel(texel + 1)), float4th(fetchTexel(texel + 2)),
                            float4th(fetchTexel(texel + 3)));
  precise vec3 halfSize = given * scale;
  precise OrientedBox result =
      OrientedBox(center, floats3(fetchTexel(texel + 1)), floats3(fetchTexel(texel + 2)),
                  floats3(fetchTexel(texel + 3)), halfSize);
  return result;
}

// The normal's length does not matter to the robust intersector; the report's compares with it.
Plane fetchCasePlane(int texel, float scale) {
  precise vec3 normal = floats3(fetchTexel(texel));
  precise vec3 point = floats3(fetchTexel(texel + 1)) * scale;
  if (!kIntersectorReport) {
    normal = broughtToOne(normal);
  }
  precise Plane result = Plane(point, normal);
  return result;
}

Triangle fetchCaseTriangle(int texel, float scale) {
  precise vec3 a = floats3(fetchTexel(texel)) * scale;
  precise vec3 b = floats3(fetchTexel(texel + 1)) * scale;
  precise vec3 c = floats3(fetchTexel(texel + 2)) * scale;
  precise Triangle result = Triangle(a, b, c);
  return result;
}

// Distance to the primitive of a case, or infinity. The kinds' distances meet in one precise local:
// returned from each branch, Mesa 22.3 rewrites the arithmetic behind them.
float intersectCase(Ray ray, int texel, float scale) {
  int kind = caseKind(texel);
  precise float result = kInfinity;
  if (kind == kCaseSphere) {
    result = intersectSphere(ray, fetchCaseSphere(texel, scale));
  } else if (kind == kCaseBox) {
    result = intersectBox(ray, fetchCaseBox(texel, scale));
  } else if (kind == kCaseOrientedBox) {
    result = intersectOrientedBox(ray, fetchCaseOrientedBox(texel, scale));
  } else if (kind == kCasePlane) {
    result = intersectPlane(ray, fetchCasePlane(texel, scale));
  } else {
    result = intersectTriangle(ray, fetchCaseTriangle(texel, scale));
  }
  return result;
}

// Smallest t within the ray's closed interval, ties to the first primitive.
Hit castCase(Ray ray, int firstTexel, int count, float scale) {
  precise Hit best = Hit(ray.tmax, kNoPrimitive);
  for (int i = 0; i < count; ++i) {
    best = nearer(best, intersectCase(ray, firstTexel + i * kCaseTexels, scale), i);
  }
  return best;
}

// The plane as its surface needs it: its normal's length is whatever was written.
Plane withUnitNormal(Plane plane) {
  precise Plane result = Plane(plane.point, unitOf(plane.normal));
  return result;
}

// An oriented box's axes are unit only to within rounding, or whatever was written.
Surface orientedCaseSurface(Ray ray, float t, OrientedBox box) {
  precise Surface surface = chosenOrientedBoxSurface(ray, t, box);
  surface.normal = unitOf(surface.normal);
  return surface;
}

// The surface of a case's primitive at a hit. One result: Mesa drops `precise` of several returns.
Surface caseSurface(Ray ray, float t, int texel, float scale) {
  int kind = caseKind(texel);
  precise Surface result = Surface(vec3(0.0f), vec3(0.0f), 0.0f);
  if (kind == kCaseSphere) {
    result = chosenSphereSurface(ray, t, fetchCaseSphere(texel, scale));
  } else if (kind == kCaseBox) {
    result = chosenBoxSurface(ray, t, fetchCaseBox(texel, scale));
  } else if (kind == kCaseOrientedBox) {
    result = orientedCaseSurface(ray, t, fetchCaseOrientedBox(texel, scale));
  } else if (kind == kCasePlane) {
    result = chosenPlaneSurface(ray, t, withUnitNormal(fetchCasePlane(texel, scale)));
  } else {
    result = chosenTriangleSurface(ray, t, fetchCaseTriangle(texel, scale));
  }
  return result;
}

// tmin in the scale of the view. One that is lost to underflow is still above zero: a hit exactly at
// the origin must not come in.
float scaledStart(float tmin, int shift) {
  precise float scaled = scaledByPower(tmin, shift);
  precise bool lost = tmin > 0.0f && scaled == 0.0f;
  precise float result = select(lost, powerOfTwo(-126), scaled);
  return result;
}

// The ray from an origin in the scale 2^room along a direction, over the interval that is tmin to
// tmax in the case's own units.
CaseView viewRay(vec3 origin, vec3 direction, float tmin, float tmax, int room, int shift) {
  precise float end = least(kLargest, tmax);
  precise float scaledEnd = least(kLargest, scaledByPower(end, shift));
  precise Ray ray = makeRay(origin, direction, scaledStart(tmin, shift), scaledEnd);
  precise bool moves = largestCoordinate(direction) > 0.0f;
  precise bool castable = isFinite(origin) && isFinite(direction) && moves && tmin <= tmax;
  precise CaseView result = CaseView(ray, tmin, end, room, shift, castable);
  return result;
}

CaseView viewCase(CaseQuery query) {
  precise float reach = greatest(query.reach, largestCoordinate(query.origin));
  int wanted = shiftToOne(reach) + kCaseExponent;
  int room = select(wanted < 126, wanted, 126);
  int aim = shiftToOne(largestCoordinate(query.direction));
  if (kIntersectorReport) {
    room = 0;
    aim = 0;
  }
  precise vec3 origin = query.origin * powerOfTwo(room);
  precise vec3 direction = query.direction * powerOfTwo(aim);
  precise CaseView result =
      viewRay(origin, direction, query.tmin, query.tmax, room, room - aim);
  return result;
}

// The closest hit whose distance in the case's own units lies in the interval too.
Hit hitInView(CaseView view, int firstTexel, int count) {
  precise Hit hit = Hit(0.0f, kNoPrimitive);
  if (view.castable) {
    hit = castCase(view.ray, firstTexel, count, powerOfTwo(view.room));
  }
  precise float t = scaledByPower(hit.t, 0 - view.shift);
  precise bool outside = t < view.tmin || t > view.tmax;
  if (outside) {
    hit.primitive = kNoPrimitive;
  }
  return hit;
}

Surface surfaceInView(CaseView view, Hit hit, int firstTexel) {
  precise Surface result = caseSurface(view.ray, hit.t, firstTexel + hit.primitive * kCaseTexels,
                                       powerOfTwo(view.room));
  return result;
}

// The hit in the case's own units.
CaseAnswer answerInView(CaseView view, Hit hit, int firstTexel) {
  precise CaseAnswer result = CaseAnswer(0.0f, kCaseMiss, vec3(0.0f));
  if (hit.primitive != kNoPrimitive) {
    result.t = scaledByPower(hit.t, 0 - view.shift);
    result.primitive = hit.primitive;
    result.normal = surfaceInView(view, hit, firstTexel).normal;
  }
  return result;
}

CaseAnswer castQuery(CaseQuery query) {
  precise CaseView view = viewCase(query);
  precise Hit hit = hitInView(view, query.firstTexel, query.count);
  precise CaseAnswer result = answerInView(view, hit, query.firstTexel);
  return result;
}

// The ray that leaves a hit as a path's does, into the cosine-weighted direction of u and v, over
// [0, largest float].
CaseView bounceInView(CaseView view, Hit hit, int firstTexel, float u, float v) {
  precise Surface surface = surfaceInView(view, hit, firstTexel);
  precise vec3 facing = facingNormal(surface.normal, view.ray.direction);
  precise vec3 origin = leavingOrigin(surface, facing);
  precise vec3 direction = tangentToWorld(facing, sampleCosineHemisphere(u, v));
  precise CaseView result = viewRay(origin, direction, 0.0f, kLargest, view.room, view.room);
  return result;
}

// The second hit, of the ray that leaves the first one.
CaseAnswer castBounce(CaseQuery query, float u, float v) {
  precise CaseView view = viewCase(query);
  precise Hit hit = hitInView(view, query.firstTexel, query.count);
  precise CaseAnswer result = CaseAnswer(0.0f, kCaseNotStarted, vec3(0.0f));
  if (hit.primitive != kNoPrimitive) {
    precise CaseView next = bounceInView(view, hit, query.firstTexel, u, v);
    precise Hit second = hitInView(next, query.firstTexel, query.count);
    result = answerInView(next, second, query.firstTexel);
  }
  return result;
}
