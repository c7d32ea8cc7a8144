#pragma once

// Twin of shaders/material.glsl: Lambert, mirror, GGX and the report's Phong lobe.

#include "cpu/kernel/sampling.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

/// A sampled direction and throughput factor: bsdf * cos / density / chance of the lobe; 0 when the
/// direction leaves the hemisphere.
template <class R>
struct ScatterSample {
  Vec3<R> direction;
  Vec3<R> weight;
};

/// Smith's masking of one direction for GGX. Walter et al. 2007, eq. 34.
template <class R>
R maskingGgx(R alpha, R cosTheta) {
  const R squared = alpha * alpha;
  const R root = squareRoot(squared + (R(1.0f) - squared) * (cosTheta * cosTheta));
  return divide(R(2.0f) * cosTheta, cosTheta + root);
}

/// Separable Smith masking, no Fresnel term: as Cycles 3.4.
template <class R>
ScatterSample<R> sampleGgx(const Vec3<R>& normal, const Vec3<R>& d, R alpha,
                           const Vec3<R>& reflectance, R u, R v) {
  const Vec3<R> h = tangentToWorld(normal, sampleGgxNormal(alpha, u, v));
  const Vec3<R> direction = reflect3(d, h);
  const R cosOut = -dot3(d, normal);
  const R cosIn = dot3(direction, normal);
  const R cosHalf = dot3(h, normal);
  const R outHalf = -dot3(d, h);
  const R masking = maskingGgx(alpha, cosOut) * maskingGgx(alpha, cosIn);
  const R factor = divide(masking * outHalf, cosOut * cosHalf);
  const R zero(0.0f);
  const MaskOf<R> valid = cosOut > zero && cosIn > zero && outHalf > zero && cosHalf > zero;
  return {direction, select(valid, reflectance * factor, Vec3<R>())};
}

/// The report's glossy lobe as a normalised one; Lafortune and Willems 1994.
template <class R>
ScatterSample<R> samplePhong(const Vec3<R>& normal, const Vec3<R>& d, R scale, R inverse,
                             const Vec3<R>& reflectance, R u, R v) {
  const Vec3<R> mirrored = reflect3(d, normal);
  const Vec3<R> direction = tangentToWorld(mirrored, samplePowerHemisphere(inverse, u, v));
  const R cosIn = greatest(dot3(direction, normal), R(0.0f));
  return {direction, reflectance * (scale * cosIn)};
}

template <class R>
ScatterSample<R> chosenScatter(MaskOf<R> condition, const ScatterSample<R>& a,
                               const ScatterSample<R>& b) {
  return {select(condition, a.direction, b.direction), select(condition, a.weight, b.weight)};
}

/// One lobe, chosen with the material's chances, and a direction from it.
/// @param normal faces against d
template <class R>
ScatterSample<R> sampleScattering(const SceneView& scene, const Scattering<R>& material,
                                  const Vec3<R>& normal, const Vec3<R>& d, R lobeChoice, R u, R v) {
  using Mask = MaskOf<R>;
  const Mask specular = lobeChoice < material.specularChance;
  ScatterSample<R> result{normal, Vec3<R>()};
  if (scene.effectDiffuse && anyLane(!specular)) {
    const Vec3<R> direction = tangentToWorld(normal, sampleCosineHemisphere(u, v));
    const ScatterSample<R> diffuse{direction, material.albedoWeight};
    result = chosenScatter(!specular, diffuse, result);
  }
  if (scene.effectMirror) {
    const Mask here = specular && material.lobe == IntOf<R>(kLobeMirror);
    if (anyLane(here)) {
      const ScatterSample<R> mirror{reflect3(d, normal), material.specularWeight};
      result = chosenScatter(here, mirror, result);
    }
  }
  if (scene.effectGgx) {
    const Mask here = specular && material.lobe == IntOf<R>(kLobeGgx);
    if (anyLane(here)) {
      const ScatterSample<R> glossy =
          sampleGgx(normal, d, material.alpha, material.specularWeight, u, v);
      result = chosenScatter(here, glossy, result);
    }
  }
  if (scene.effectPhong) {
    const Mask here = specular && material.lobe == IntOf<R>(kLobePhong);
    if (anyLane(here)) {
      const ScatterSample<R> glossy = samplePhong(normal, d, material.phongScale,
                                                  material.phongInverse, material.specularWeight,
                                                  u, v);
      result = chosenScatter(here, glossy, result);
    }
  }
  return result;
}

/// GGX lobe times cosine towards the unit direction i.
template <class R>
Vec3<R> evaluateGgx(const Vec3<R>& normal, const Vec3<R>& d, const Vec3<R>& i, R alpha,
                    const Vec3<R>& reflectance) {
  const Vec3<R> h = normalize3(i - d);
  const R cosOut = -dot3(d, normal);
  const R cosIn = dot3(i, normal);
  const R masking = maskingGgx(alpha, cosOut) * maskingGgx(alpha, cosIn);
  const Vec3<R> across = cross3(h, normal);
  const R density = distributionGgx(alpha, dot3(h, normal), dot3(across, across));
  const R factor = divide(density * masking, R(4.0f) * cosOut);
  return select(cosOut > R(0.0f) && cosIn > R(0.0f), reflectance * factor, Vec3<R>());
}

/// Phong lobe times cosine towards the unit direction i.
template <class R>
Vec3<R> evaluatePhong(const Vec3<R>& normal, const Vec3<R>& d, const Vec3<R>& i, R exponent,
                      const Vec3<R>& reflectance) {
  const R cosIn = greatest(dot3(i, normal), R(0.0f));
  const R lobe = power(dot3(reflect3(d, normal), i), exponent);
  return reflectance * (((exponent + R(2.0f)) * constant<R>(kInverseTwoPi)) * (lobe * cosIn));
}

/// All lobes that are not deltas, times cosine, for light that arrives from the unit direction i.
template <class R>
Vec3<R> evaluateReflectance(const SceneView& scene, const Reflectance<R>& material,
                            const Vec3<R>& normal, const Vec3<R>& d, const Vec3<R>& i) {
  using Mask = MaskOf<R>;
  const R cosIn = greatest(dot3(i, normal), R(0.0f));
  Vec3<R> result = material.albedo * (constant<R>(kInversePi) * cosIn);
  const Mask ggx = material.lobe == IntOf<R>(kLobeGgx);
  if (scene.effectGgx && anyLane(ggx)) {
    const Vec3<R> glossy = result + evaluateGgx(normal, d, i, material.alpha, material.specular);
    result = select(ggx, glossy, result);
  }
  const Mask phong = material.lobe == IntOf<R>(kLobePhong);
  if (scene.effectPhong && anyLane(phong)) {
    const Vec3<R> glossy =
        result + evaluatePhong(normal, d, i, material.phongExponent, material.specular);
    result = select(phong, glossy, result);
  }
  return result;
}

TWINTRACE_KERNEL_END
