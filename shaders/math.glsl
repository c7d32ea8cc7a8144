// Strict maths: every operation is one that GL rounds correctly (measured: the device's passport) or
// is built from such operations, in a written order. math_native.glsl has the same functions by the
// driver's builtins. Polynomials: Cephes single precision (Moshier), ranges and errors at each.
#pragma once

#include "corrected.glsl"
#include "number.glsl"

const float kPi = 3.14159265f;
const float kInversePi = 0.318309886f;
const float kTwoPi = 6.28318531f;
const float kInverseTwoPi = 0.159154943f;

// The nearest float, of which kCorrectedDivision says that the device's own division misses it.
float divide(float a, float b) {
  if (kCorrectedDivision) {
    return correctedQuotient(a, b);
  }
  return approximateQuotient(a, b);
}

vec3 divide(vec3 a, float b) {
  precise vec3 result = vec3(divide(a.x, b), divide(a.y, b), divide(a.z, b));
  return result;
}

// The nearest float, of which kCorrectedRoot says that the device's own square root misses it.
float squareRoot(float x) {
  if (kCorrectedRoot) {
    return correctedRoot(x);
  }
  return approximateRoot(x);
}

float dot3(vec3 a, vec3 b) {
  precise float result = (a.x * b.x + a.y * b.y) + a.z * b.z;
  return result;
}

vec3 cross3(vec3 a, vec3 b) {
  precise vec3 result =
      vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  return result;
}

float length3(vec3 v) {
  precise float result = squareRoot(dot3(v, v));
  return result;
}

vec3 normalize3(vec3 v) {
  precise float scale = divide(1.0f, length3(v));
  precise vec3 result = v * scale;
  return result;
}

// Mirror direction of the incoming direction d at a surface with unit normal n.
vec3 reflect3(vec3 d, vec3 n) {
  precise float twice = 2.0f * dot3(d, n);
  precise vec3 result = d - n * twice;
  return result;
}

struct SinCos {
  float sine;
  float cosine;
};

// Sine and cosine of `quarters` quarter turns plus `angle` radians, |angle| <= pi/4 (+ rounding).
SinCos sinCosReduced(float angle, int quarters) {
  precise float z = angle * angle;
  precise float s =
      ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * (z * angle) + angle;
  precise float c = ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z +
                     4.166664568298827e-2f) * (z * z) - 0.5f * z + 1.0f;
  precise bool swapped = (quarters & 1) != 0;
  precise float sineSize = select(swapped, c, s);
  precise float cosineSize = select(swapped, s, c);
  precise float sine = select((quarters & 2) != 0, -sineSize, sineSize);
  precise float cosine = select(((quarters + 1) & 2) != 0, -cosineSize, cosineSize);
  precise SinCos result = SinCos(sine, cosine);
  return result;
}

// Sine and cosine of 2 pi u. The reduction in turns is exact, so the absolute error is below
// 1.2e-7 for u in [0, 1].
SinCos sinCosTurns(float u) {
  precise float quarters = 4.0f * u;
  precise float raised = quarters + 0.5f;
  precise float nearest = floor(raised);
  precise float angle = (quarters - nearest) * 1.57079633f;
  precise SinCos result = sinCosReduced(angle, int(nearest));
  return result;
}

// Sine of x radians by a three-term Cody-Waite reduction: absolute error below 1e-6 for
// |x| < 50,000; beyond, still within [-1, 1], without meaning.
float sine(float x) {
  precise float raised = x * 0.636619772f + 0.5f;
  precise float k = floor(raised);
  precise float reduced =
      ((x - k * 1.5703125f) - k * 4.837512969970703e-4f) - k * 7.549789948768648e-8f;
  precise float angle = clampTo(reduced, -0.7853982f, 0.7853982f);
  precise float inTurns = k * 0.25f;
  precise float turns = floor(inTurns);
  precise float part = k - 4.0f * turns;
  precise float quarters = clampTo(part, 0.0f, 3.0f);
  precise SinCos both = sinCosReduced(angle, int(quarters));
  return both.sine;
}

// Base-2 logarithm of a positive normal x; relative error below 2e-7 away from 1.
float log2Of(float x) {
  int bits = floatBitsToInt(x);
  int exponent = ((bits >> 23) & 255) - 126;
  precise float fraction = intBitsToFloat((bits & 0x007fffff) | 0x3f000000);
  precise bool low = fraction < 0.707106781f;
  precise float doubled = fraction + fraction;
  precise float mantissa = select(low, doubled, fraction);
  precise float m = mantissa - 1.0f;
  precise float z = m * m;
  precise float p = 7.0376836292e-2f;
  p = p * m - 1.1514610310e-1f;
  p = p * m + 1.1676998740e-1f;
  p = p * m - 1.2420140846e-1f;
  p = p * m + 1.4249322787e-1f;
  p = p * m - 1.6668057665e-1f;
  p = p * m + 2.0000714765e-1f;
  p = p * m - 2.4999993993e-1f;
  p = p * m + 3.3333331174e-1f;
  precise float natural = m + (p * (m * z) - 0.5f * z);
  precise float result = natural * 1.44269504f + float(select(low, exponent - 1, exponent));
  return result;
}

// 2^x, x held within [-126, 127]; relative error below 2e-7.
float exp2Of(float x) {
  precise float held = clampTo(x, -126.0f, 127.0f);
  precise float raised = held + 0.5f;
  precise float k = floor(raised);
  precise float f = held - k;
  precise float p = 1.535336188319500e-4f;
  p = p * f + 1.339887440266574e-3f;
  p = p * f + 9.618437357674640e-3f;
  p = p * f + 5.550332471162809e-2f;
  p = p * f + 2.402264791363012e-1f;
  p = p * f + 6.931472028550421e-1f;
  precise float mantissa = p * f + 1.0f;
  precise float scale = intBitsToFloat((int(k) + 127) << 23);
  precise float result = mantissa * scale;
  return result;
}

// x^y for x >= 0 and y > 0; 0 for x that is not positive.
float power(float x, float y) {
  precise float exponent = y * log2Of(x);
  precise float raised = exp2Of(exponent);
  precise float result = select(x > 0.0f, raised, 0.0f);
  return result;
}

// Angle of the point (x, y) in radians, in [-pi, pi]; 0 at the origin. Absolute error below 3e-7.
float arcTangent2(float y, float x) {
  precise float ax = absolute(x);
  precise float ay = absolute(y);
  precise bool steep = ay > ax;
  precise float longer = select(steep, ay, ax);
  precise float shorter = select(steep, ax, ay);
  precise float ratio = select(longer > 0.0f, divide(shorter, longer), 0.0f);
  precise bool folded = ratio > 0.414213562f;
  precise float less = ratio - 1.0f;
  precise float more = ratio + 1.0f;
  precise float a = select(folded, divide(less, more), ratio);
  precise float z = a * a;
  precise float p = (((8.05374449538e-2f * z - 1.38776856032e-1f) * z + 1.99777106478e-1f) * z -
                     3.33329491539e-1f) * (z * a) + a;
  precise float unfolded = 0.785398163f + p;
  precise float base = select(folded, unfolded, p);
  precise float complement = 1.57079633f - base;
  precise float unswapped = select(steep, complement, base);
  precise float supplement = kPi - unswapped;
  precise float upper = select(x < 0.0f, supplement, unswapped);
  precise float result = select(y < 0.0f, -upper, upper);
  return result;
}

// Angle whose cosine is x, held within [-1, 1], in radians; accurate near both ends.
float arcCosine(float x) {
  precise float held = clampTo(x, -1.0f, 1.0f);
  precise float less = 1.0f - held;
  precise float more = 1.0f + held;
  precise float result = 2.0f * arcTangent2(squareRoot(less), squareRoot(more));
  return result;
}
