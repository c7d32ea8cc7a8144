#pragma once

// Twin of shaders/sampling.glsl: directions and points from uniform random numbers, with their
// densities.

#include "cpu/kernel/math.h"

TWINTRACE_KERNEL_BEGIN

/// A direction in the frame whose third axis is the unit vector n (eq. 11, algorithm 3).
template <class R>
Vec3<R> tangentToWorld(const Vec3<R>& n, const Vec3<R>& local) {
  const MaskOf<R> nearX = absolute(n.x) > R(0.99f);
  const Vec3<R> helper = select(nearX, Vec3<R>(R(0.0f), R(0.0f), R(1.0f)),
                                Vec3<R>(R(1.0f), R(0.0f), R(0.0f)));
  const Vec3<R> tangent = normalize3(cross3(n, helper));
  const Vec3<R> binormal = normalize3(cross3(n, tangent));
  return (tangent * local.x + binormal * local.y) + n * local.z;
}

/// Unit direction with polar cosine cosTheta and azimuth v turns, z up.
template <class R>
Vec3<R> polarDirection(R cosTheta, R v) {
  const R sinTheta = squareRoot(greatest(R(1.0f) - cosTheta * cosTheta, R(0.0f)));
  const SinCos<R> azimuth = sinCosTurns(v);
  return {azimuth.cosine * sinTheta, azimuth.sine * sinTheta, cosTheta};
}

/// Direction about +z with density (exponent + 1) / (2 pi) cos^exponent per solid angle, eq. 11.
/// @param inverse 1 / (exponent + 1)
template <class R>
Vec3<R> samplePowerHemisphere(R inverse, R u, R v) {
  return polarDirection(power(u, inverse), v);
}

template <class R>
R pdfPowerHemisphere(R exponent, R cosTheta) {
  const R density = ((exponent + R(1.0f)) * constant<R>(kInverseTwoPi)) * power(cosTheta, exponent);
  return select(cosTheta > R(0.0f), density, R(0.0f));
}

/// A squared cosine below which rounding may turn a direction below the surface: a cosine of 2^-19.
inline constexpr float kLeastCosineSquared = 0x1p-38f;

/// Direction about +z with density cos / pi.
template <class R>
Vec3<R> sampleCosineHemisphere(R u, R v) {
  return polarDirection(squareRoot(greatest(u, R(kLeastCosineSquared))), v);
}

template <class R>
R pdfCosineHemisphere(R cosTheta) {
  return select(cosTheta > R(0.0f), cosTheta * constant<R>(kInversePi), R(0.0f));
}

/// Direction uniform over the cone about +z whose rim has 1 - cos = height.
template <class R>
Vec3<R> sampleCone(R height, R u, R v) {
  const R drop = u * height;
  const R sinTheta = squareRoot(greatest(drop * (R(2.0f) - drop), R(0.0f)));
  const SinCos<R> azimuth = sinCosTurns(v);
  return {azimuth.cosine * sinTheta, azimuth.sine * sinTheta, R(1.0f) - drop};
}

template <class R>
R pdfCone(R height, R cosTheta) {
  const R density = divide(constant<R>(kInverseTwoPi), height);
  return select(cosTheta >= R(1.0f) - height, density, R(0.0f));
}

/// Point uniform over the unit disk, z = 0.
template <class R>
Vec3<R> sampleDisk(R u, R v) {
  const R radius = squareRoot(u);
  const SinCos<R> angle = sinCosTurns(v);
  return {radius * angle.cosine, radius * angle.sine, R(0.0f)};
}

/// Normal about +z with density D(h) cos(h) of the GGX distribution, alpha > 0. Walter et al. 2007,
/// eq. 35-36. Changed: the sine is not taken from the cosine, which would leave steps of 1e-4 and more
/// in the angles of narrow lobes.
template <class R>
Vec3<R> sampleGgxNormal(R alpha, R u, R v) {
  const R squared = alpha * alpha;
  const R below = (R(1.0f) - u) + u * squared;
  const R cosTheta = squareRoot(divide(R(1.0f) - u, below));
  const R sinTheta = squareRoot(divide(u * squared, below));
  const SinCos<R> azimuth = sinCosTurns(v);
  return {azimuth.cosine * sinTheta, azimuth.sine * sinTheta, cosTheta};
}

/// GGX distribution of normals D(h). Walter et al. 2007, eq. 33. Changed: the sine is given, since it
/// decides in narrow lobes, where the cosine no longer tells it.
template <class R>
R distributionGgx(R alpha, R cosTheta, R sinSquared) {
  const R squared = alpha * alpha;
  const R below = sinSquared + (cosTheta * cosTheta) * squared;
  const R density = divide(squared, (constant<R>(kPi) * below) * below);
  return select(cosTheta > R(0.0f), density, R(0.0f));
}

/// Density of sampleGgxNormal.
template <class R>
R pdfGgxNormal(R alpha, R cosTheta) {
  const R sinSquared = (R(1.0f) - cosTheta) * (R(1.0f) + cosTheta);
  return distributionGgx(alpha, cosTheta, sinSquared) * cosTheta;
}

TWINTRACE_KERNEL_END
