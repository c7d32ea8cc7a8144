// Correctly rounded division and square root for devices whose own are only near: the device's
// answer on the mantissas, put right by its integer remainder, which neither contraction nor
// flushing can touch. Remainders wrap at 32 bits but are below 2^30, so that the wrapped one is the
// true one. No result is a tie: the midpoint of two floats has one bit too many.
#pragma once

#include "number.glsl"

const uint kInfinityBits = 0x7f800000u;
const uint kNanBits = 0x7fc00000u;

// The device's own division, off by at most 4 ulp for a and b in [1, 2).
float approximateQuotient(float a, float b) {
  precise float result = a / b;
  return result;
}

// The device's own square root, off by at most 4 ulp for x in [1, 4).
float approximateRoot(float x) {
  precise float result = sqrt(x);
  return result;
}

// The mantissa of those bits as an integer in [2^23, 2^24).
uint mantissaOf(uint bits) {
  return (bits & 0x007fffffu) | 0x00800000u;
}

// The same mantissa as a float in [1, 2).
float unitMantissa(float x) {
  precise float result = uintBitsToFloat((floatBitsToUint(x) & 0x007fffffu) | 0x3f800000u);
  return result;
}

// A float from sign, biased exponent and a mantissa in [2^23, 2^24]: infinite beyond the range of
// normal numbers, zero below it.
uint composedBits(uint sign, int exponent, uint mantissa) {
  int held = select(exponent < 0, 0, select(exponent > 255, 255, exponent));
  uint size = (uint(held) << 23) + mantissa - 0x00800000u;
  uint finite = select(size < 0x00800000u, 0u, size);
  uint known = select(size < kInfinityBits, finite, kInfinityBits);
  return sign | select(exponent < 0, 0u, known);
}

// The quotient where an operand is zero (a denormal counts as zero), infinite or NaN; sizes are the
// operands without sign.
uint specialQuotientBits(uint sign, uint sizeA, uint sizeB) {
  precise bool zeroA = sizeA < 0x00800000u;
  precise bool zeroB = sizeB < 0x00800000u;
  precise bool infiniteA = sizeA == kInfinityBits;
  precise bool infiniteB = sizeB == kInfinityBits;
  precise bool undefinedSize = sizeA > kInfinityBits || sizeB > kInfinityBits;
  precise bool undefinedPair = (zeroA && zeroB) || (infiniteA && infiniteB);
  uint size = select(zeroB || infiniteA, kInfinityBits, 0u);
  return select(undefinedSize || undefinedPair, kNanBits, sign | size);
}

// a / b to the nearest float, from a guess at the quotient of their unit mantissas that is off by
// at most 4 ulp.
float refinedQuotient(float a, float b, float guess) {
  uint bitsA = floatBitsToUint(a);
  uint bitsB = floatBitsToUint(b);
  uint sizeA = bitsA & 0x7fffffffu;
  uint sizeB = bitsB & 0x7fffffffu;
  uint sign = (bitsA ^ bitsB) & 0x80000000u;
  uint mantissaA = mantissaOf(bitsA);
  uint mantissaB = mantissaOf(bitsB);
  uint low = select(mantissaA < mantissaB, 1u, 0u);
  precise float scale = select(mantissaA < mantissaB, 16777216.0f, 8388608.0f);
  precise float scaled = guess * scale;
  uint q = uint(int(scaled)) - 8u;
  uint rest = (mantissaA << (23u + low)) - q * mantissaB;
  for (uint step = 8u; step > 0u; step = step >> 1) {
    uint part = select(rest < step * mantissaB, 0u, step);
    q = q + part;
    rest = rest - part * mantissaB;
  }
  uint rounded = q + select(2u * rest > mantissaB, 1u, 0u);
  int exponent = int(sizeA >> 23) - int(sizeB >> 23) + 127 - int(low);
  precise bool ordinaryA = sizeA >= 0x00800000u && sizeA < kInfinityBits;
  precise bool ordinaryB = sizeB >= 0x00800000u && sizeB < kInfinityBits;
  uint bits = select(ordinaryA && ordinaryB, composedBits(sign, exponent, rounded),
                     specialQuotientBits(sign, sizeA, sizeB));
  precise float result = uintBitsToFloat(bits);
  return result;
}

// The mantissa of x as a float in [1, 4), so that an even exponent is left.
float rootMantissa(float x) {
  uint bits = floatBitsToUint(x);
  uint exponent = select(((bits >> 23) & 1u) == 0u, 0x40000000u, 0x3f800000u);
  precise float result = uintBitsToFloat((bits & 0x007fffffu) | exponent);
  return result;
}

// sqrt(x) to the nearest float, from a guess at the root of its root mantissa that is off by at most
// 4 ulp.
float refinedRoot(float x, float guess) {
  uint bits = floatBitsToUint(x);
  uint size = bits & 0x7fffffffu;
  uint odd = select(((bits >> 23) & 1u) == 0u, 1u, 0u);
  precise float scaled = guess * 8388608.0f;
  uint q = uint(int(scaled)) - 8u;
  uint rest = (mantissaOf(bits) << (23u + odd)) - q * q;
  for (uint step = 8u; step > 0u; step = step >> 1) {
    uint growth = (2u * q + step) * step;
    precise bool fits = rest >= growth;
    q = q + select(fits, step, 0u);
    rest = rest - select(fits, growth, 0u);
  }
  uint rounded = q + select(rest > q, 1u, 0u);
  int exponent = (int(size >> 23) - 127 - int(odd)) / 2 + 127;
  precise bool positive = bits >= 0x00800000u && bits < kInfinityBits;
  precise bool kept = size < 0x00800000u || bits == kInfinityBits;
  uint ending = select(size < 0x00800000u, bits & 0x80000000u, bits);
  uint special = select(kept, ending, kNanBits);
  uint rootBits = select(positive, composedBits(0u, exponent, rounded), special);
  precise float result = uintBitsToFloat(rootBits);
  return result;
}

// a / b to the nearest float; denormals are zero.
float correctedQuotient(float a, float b) {
  precise float guess = approximateQuotient(unitMantissa(a), unitMantissa(b));
  precise float result = refinedQuotient(a, b, guess);
  return result;
}

// sqrt(x) to the nearest float; denormals are zero.
float correctedRoot(float x) {
  precise float guess = approximateRoot(rootMantissa(x));
  precise float result = refinedRoot(x, guess);
  return result;
}
