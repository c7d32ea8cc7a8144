#pragma once

// Twin of shaders/math.glsl: strict maths, the same operations in the same order.

#include "cpu/kernel/corrected.h"
#include "cpu/kernel/math_native.h"

TWINTRACE_KERNEL_BEGIN

template <StrictNumber R>
R divide(R a, R b) {
  return a / b;
}

template <StrictNumber R>
Vec3<R> divide(const Vec3<R>& a, R b) {
  return {divide(a.x, b), divide(a.y, b), divide(a.z, b)};
}

template <StrictNumber R>
R squareRoot(R x) {
  return rootOf(x);
}

template <StrictNumber R>
R dot3(const Vec3<R>& a, const Vec3<R>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <StrictNumber R>
Vec3<R> cross3(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <StrictNumber R>
R length3(const Vec3<R>& v) {
  return squareRoot(dot3(v, v));
}

template <StrictNumber R>
Vec3<R> normalize3(const Vec3<R>& v) {
  const R scale = divide(R(1.0f), length3(v));
  return v * scale;
}

/// Mirror direction of the incoming direction d at a surface with unit normal n.
template <StrictNumber R>
Vec3<R> reflect3(const Vec3<R>& d, const Vec3<R>& n) {
  const R twice = R(2.0f) * dot3(d, n);
  return d - n * twice;
}

/// Sine and cosine of `quarters` quarter turns plus `angle` radians, |angle| <= pi/4 (+ rounding).
template <StrictNumber R>
SinCos<R> sinCosReduced(R angle, IntOf<R> quarters) {
  const R z = angle * angle;
  const R s = ((R(-1.9515295891e-4f) * z + R(8.3321608736e-3f)) * z - R(1.6666654611e-1f)) *
                  (z * angle) +
              angle;
  const R c = ((R(2.443315711809948e-5f) * z - R(1.388731625493765e-3f)) * z +
               R(4.166664568298827e-2f)) *
                  (z * z) -
              R(0.5f) * z + R(1.0f);
  const MaskOf<R> swapped = (quarters & 1) != 0;
  const R sineSize = select(swapped, c, s);
  const R cosineSize = select(swapped, s, c);
  const R sine = select((quarters & 2) != 0, -sineSize, sineSize);
  const R cosine = select(((quarters + 1) & 2) != 0, -cosineSize, cosineSize);
  return {sine, cosine};
}

/// Sine and cosine of 2 pi u; absolute error below 1.2e-7 for u in [0, 1].
template <StrictNumber R>
SinCos<R> sinCosTurns(R u) {
  const R quarters = R(4.0f) * u;
  const R nearest = floorOf(quarters + R(0.5f));
  const R angle = (quarters - nearest) * R(1.57079633f);
  return sinCosReduced(angle, toInt(nearest));
}

/// Sine of x radians: absolute error below 1e-6 for |x| < 50,000; beyond, still within [-1, 1].
template <StrictNumber R>
R sine(R x) {
  const R k = floorOf(x * R(0.636619772f) + R(0.5f));
  const R reduced = ((x - k * R(1.5703125f)) - k * R(4.837512969970703e-4f)) -
                    k * R(7.549789948768648e-8f);
  const R angle = clampTo(reduced, R(-0.7853982f), R(0.7853982f));
  const R turns = floorOf(k * R(0.25f));
  const R quarters = clampTo(k - R(4.0f) * turns, R(0.0f), R(3.0f));
  return sinCosReduced(angle, toInt(quarters)).sine;
}

/// Base-2 logarithm of a positive normal x; relative error below 2e-7 away from 1.
template <StrictNumber R>
R log2Of(R x) {
  const IntOf<R> bits = bitsOf(x);
  const IntOf<R> exponent = ((bits >> 23) & 255) - 126;
  const R fraction = floatFromBits((bits & 0x007fffff) | 0x3f000000);
  const MaskOf<R> low = fraction < R(0.707106781f);
  const R mantissa = select(low, fraction + fraction, fraction);
  const R m = mantissa - R(1.0f);
  const R z = m * m;
  R p = R(7.0376836292e-2f);
  p = p * m - R(1.1514610310e-1f);
  p = p * m + R(1.1676998740e-1f);
  p = p * m - R(1.2420140846e-1f);
  p = p * m + R(1.4249322787e-1f);
  p = p * m - R(1.6668057665e-1f);
  p = p * m + R(2.0000714765e-1f);
  p = p * m - R(2.4999993993e-1f);
  p = p * m + R(3.3333331174e-1f);
  const R natural = m + (p * (m * z) - R(0.5f) * z);
  return natural * R(1.44269504f) + toNumber<R>(select(low, exponent - 1, exponent));
}

/// 2^x, x held within [-126, 127]; relative error below 2e-7.
template <StrictNumber R>
R exp2Of(R x) {
  const R held = clampTo(x, R(-126.0f), R(127.0f));
  const R k = floorOf(held + R(0.5f));
  const R f = held - k;
  R p = R(1.535336188319500e-4f);
  p = p * f + R(1.339887440266574e-3f);
  p = p * f + R(9.618437357674640e-3f);
  p = p * f + R(5.550332471162809e-2f);
  p = p * f + R(2.402264791363012e-1f);
  p = p * f + R(6.931472028550421e-1f);
  const R mantissa = p * f + R(1.0f);
  const R scale = floatFromBits((toInt(k) + 127) << 23);
  return mantissa * scale;
}

/// x^y for x >= 0 and y > 0; 0 for x that is not positive.
template <StrictNumber R>
R power(R x, R y) {
  return select(x > R(0.0f), exp2Of(y * log2Of(x)), R(0.0f));
}

/// Angle of the point (x, y) in radians, in [-pi, pi]; 0 at the origin. Absolute error below 3e-7.
template <StrictNumber R>
R arcTangent2(R y, R x) {
  const R ax = absolute(x);
  const R ay = absolute(y);
  const MaskOf<R> steep = ay > ax;
  const R longer = select(steep, ay, ax);
  const R shorter = select(steep, ax, ay);
  const R ratio = select(longer > R(0.0f), divide(shorter, longer), R(0.0f));
  const MaskOf<R> folded = ratio > R(0.414213562f);
  const R a = select(folded, divide(ratio - R(1.0f), ratio + R(1.0f)), ratio);
  const R z = a * a;
  const R p = (((R(8.05374449538e-2f) * z - R(1.38776856032e-1f)) * z + R(1.99777106478e-1f)) * z -
               R(3.33329491539e-1f)) *
                  (z * a) +
              a;
  const R base = select(folded, R(0.785398163f) + p, p);
  const R unswapped = select(steep, R(1.57079633f) - base, base);
  const R upper = select(x < R(0.0f), constant<R>(kPi) - unswapped, unswapped);
  return select(y < R(0.0f), -upper, upper);
}

/// Angle whose cosine is x, held within [-1, 1], in radians; accurate near both ends.
template <StrictNumber R>
R arcCosine(R x) {
  const R held = clampTo(x, R(-1.0f), R(1.0f));
  return R(2.0f) * arcTangent2(squareRoot(R(1.0f) - held), squareRoot(R(1.0f) + held));
}

TWINTRACE_KERNEL_END
