// Directions and points from uniform random numbers, with their densities.
#pragma once

#include "math.glsl"

// A direction in the frame whose third axis is the unit vector n. Helper axis and order of the
// cross products as in the report's ancestor (eq. 11, algorithm 3).
vec3 tangentToWorld(vec3 n, vec3 local) {
  precise bool nearX = absolute(n.x) > 0.99f;
  precise vec3 helper = select(nearX, vec3(0.0f, 0.0f, 1.0f), vec3(1.0f, 0.0f, 0.0f));
  precise vec3 tangent = normalize3(cross3(n, helper));
  precise vec3 binormal = normalize3(cross3(n, tangent));
  precise vec3 result = (tangent * local.x + binormal * local.y) + n * local.z;
  return result;
}

// Unit direction with polar cosine cosTheta and azimuth v turns, z up.
vec3 polarDirection(float cosTheta, float v) {
  precise float sinSquared = 1.0f - cosTheta * cosTheta;
  precise float sinTheta = squareRoot(greatest(sinSquared, 0.0f));
  precise SinCos azimuth = sinCosTurns(v);
  precise vec3 result = vec3(azimuth.cosine * sinTheta, azimuth.sine * sinTheta, cosTheta);
  return result;
}

// Direction about +z with density (exponent + 1) / (2 pi) cos^exponent per solid angle, eq. 11.
// inverse = 1 / (exponent + 1).
vec3 samplePowerHemisphere(float inverse, float u, float v) {
  precise vec3 result = polarDirection(power(u, inverse), v);
  return result;
}

float pdfPowerHemisphere(float exponent, float cosTheta) {
  precise float density = ((exponent + 1.0f) * kInverseTwoPi) * power(cosTheta, exponent);
  precise float result = select(cosTheta > 0.0f, density, 0.0f);
  return result;
}

// A squared cosine below which rounding may turn a direction below the surface: a cosine of 2^-19.
const float kLeastCosineSquared = 3.637978807091713e-12f;

// Direction about +z with density cos / pi: exponent 1, where the power is a square root.
vec3 sampleCosineHemisphere(float u, float v) {
  precise float squared = greatest(u, kLeastCosineSquared);
  precise vec3 result = polarDirection(squareRoot(squared), v);
  return result;
}

float pdfCosineHemisphere(float cosTheta) {
  precise float density = cosTheta * kInversePi;
  precise float result = select(cosTheta > 0.0f, density, 0.0f);
  return result;
}

// Direction uniform over the cone about +z whose rim has 1 - cos = height; density 1 / (2 pi height).
// The height is passed instead of the cosine since 1 - cos cancels for narrow cones.
vec3 sampleCone(float height, float u, float v) {
  precise float drop = u * height;
  precise float sinSquared = drop * (2.0f - drop);
  precise float sinTheta = squareRoot(greatest(sinSquared, 0.0f));
  precise SinCos azimuth = sinCosTurns(v);
  precise vec3 result =
      vec3(azimuth.cosine * sinTheta, azimuth.sine * sinTheta, 1.0f - drop);
  return result;
}

float pdfCone(float height, float cosTheta) {
  precise float density = divide(kInverseTwoPi, height);
  precise float rim = 1.0f - height;
  precise float result = select(cosTheta >= rim, density, 0.0f);
  return result;
}

// Point uniform over the unit disk, z = 0.
vec3 sampleDisk(float u, float v) {
  precise float radius = squareRoot(u);
  precise SinCos angle = sinCosTurns(v);
  precise vec3 result = vec3(radius * angle.cosine, radius * angle.sine, 0.0f);
  return result;
}

// Normal about +z with density D(h) cos(h) of the GGX distribution, alpha > 0. Walter et al. 2007,
// "Microfacet Models for Refraction", eq. 35-36. Changed: the sine is not taken from the cosine, which
// would leave steps of 1e-4 and more in the angles of narrow lobes.
vec3 sampleGgxNormal(float alpha, float u, float v) {
  precise float squared = alpha * alpha;
  precise float below = (1.0f - u) + u * squared;
  precise float cosAbove = 1.0f - u;
  precise float sinAbove = u * squared;
  precise float cosTheta = squareRoot(divide(cosAbove, below));
  precise float sinTheta = squareRoot(divide(sinAbove, below));
  precise SinCos azimuth = sinCosTurns(v);
  precise vec3 result =
      vec3(azimuth.cosine * sinTheta, azimuth.sine * sinTheta, cosTheta);
  return result;
}

// GGX distribution of normals D(h). Walter et al. 2007, eq. 33. Changed: the sine is given, since it
// decides in narrow lobes, where the cosine no longer tells it.
float distributionGgx(float alpha, float cosTheta, float sinSquared) {
  precise float squared = alpha * alpha;
  precise float below = sinSquared + (cosTheta * cosTheta) * squared;
  precise float scaled = (kPi * below) * below;
  precise float density = divide(squared, scaled);
  precise float result = select(cosTheta > 0.0f, density, 0.0f);
  return result;
}

// Density of sampleGgxNormal.
float pdfGgxNormal(float alpha, float cosTheta) {
  precise float sinSquared = (1.0f - cosTheta) * (1.0f + cosTheta);
  precise float result = distributionGgx(alpha, cosTheta, sinSquared) * cosTheta;
  return result;
}
