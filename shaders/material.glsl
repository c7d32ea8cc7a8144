// Reflection: Lambert, mirror, GGX and the report's Phong lobe; sampling one lobe, and evaluating
// all that are not deltas.
#pragma once

#include "sampling.glsl"
#include "scene_access.glsl"

// A sampled direction and throughput factor: bsdf * cos / density / chance of the lobe; 0 when the
// direction leaves the hemisphere.
struct ScatterSample {
  vec3 direction;
  vec3 weight;
};

// Smith's masking of one direction for GGX. Walter et al. 2007, eq. 34.
float maskingGgx(float alpha, float cosTheta) {
  precise float squared = alpha * alpha;
  precise float widened = squared + (1.0f - squared) * (cosTheta * cosTheta);
  precise float root = squareRoot(widened);
  precise float twice = 2.0f * cosTheta;
  precise float sum = cosTheta + root;
  precise float result = divide(twice, sum);
  return result;
}

// Separable Smith masking, no Fresnel term: as Cycles 3.4.
ScatterSample sampleGgx(vec3 normal, vec3 d, float alpha, vec3 reflectance, float u, float v) {
  precise vec3 h = tangentToWorld(normal, sampleGgxNormal(alpha, u, v));
  precise vec3 direction = reflect3(d, h);
  precise float cosOut = -dot3(d, normal);
  precise float cosIn = dot3(direction, normal);
  precise float cosHalf = dot3(h, normal);
  precise float outHalf = -dot3(d, h);
  precise float masking = maskingGgx(alpha, cosOut) * maskingGgx(alpha, cosIn);
  precise float above = masking * outHalf;
  precise float below = cosOut * cosHalf;
  precise float factor = divide(above, below);
  precise bool valid = cosOut > 0.0f && cosIn > 0.0f && outHalf > 0.0f && cosHalf > 0.0f;
  precise vec3 reflected = reflectance * factor;
  precise vec3 weight = select(valid, reflected, vec3(0.0f));
  precise ScatterSample result = ScatterSample(direction, weight);
  return result;
}

// The report's glossy lobe as a normalised one: exponent n about the mirror direction with
// bsdf = reflectance (n + 2) / (2 pi) cos^n; Lafortune and Willems 1994.
ScatterSample samplePhong(vec3 normal, vec3 d, float scale, float inverse, vec3 reflectance, float u,
                          float v) {
  precise vec3 mirrored = reflect3(d, normal);
  precise vec3 direction = tangentToWorld(mirrored, samplePowerHemisphere(inverse, u, v));
  precise float cosIn = greatest(dot3(direction, normal), 0.0f);
  precise vec3 weight = reflectance * (scale * cosIn);
  precise ScatterSample result = ScatterSample(direction, weight);
  return result;
}

ScatterSample chosenScatter(bool condition, ScatterSample a, ScatterSample b) {
  precise vec3 direction = select(condition, a.direction, b.direction);
  precise vec3 weight = select(condition, a.weight, b.weight);
  precise ScatterSample result = ScatterSample(direction, weight);
  return result;
}

// One lobe, chosen with the material's chances, and a direction from it. `normal` faces against d.
ScatterSample sampleScattering(Scattering material, vec3 normal, vec3 d, float lobeChoice, float u,
                               float v) {
  precise bool specular = lobeChoice < material.specularChance;
  precise ScatterSample result = ScatterSample(normal, vec3(0.0f));
  if (kEffectDiffuse && anyLane(!specular)) {
    precise vec3 direction = tangentToWorld(normal, sampleCosineHemisphere(u, v));
    precise ScatterSample diffuse = ScatterSample(direction, material.albedoWeight);
    result = chosenScatter(!specular, diffuse, result);
  }
  if (kEffectMirror) {
    precise bool here = specular && material.lobe == kLobeMirror;
    if (anyLane(here)) {
      precise ScatterSample mirror = ScatterSample(reflect3(d, normal), material.specularWeight);
      result = chosenScatter(here, mirror, result);
    }
  }
  if (kEffectGgx) {
    precise bool here = specular && material.lobe == kLobeGgx;
    if (anyLane(here)) {
      precise ScatterSample glossy =
          sampleGgx(normal, d, material.alpha, material.specularWeight, u, v);
      result = chosenScatter(here, glossy, result);
    }
  }
  if (kEffectPhong) {
    precise bool here = specular && material.lobe == kLobePhong;
    if (anyLane(here)) {
      precise ScatterSample glossy = samplePhong(normal, d, material.phongScale,
                                                 material.phongInverse, material.specularWeight,
                                                 u, v);
      result = chosenScatter(here, glossy, result);
    }
  }
  return result;
}

// GGX lobe times cosine towards the unit direction i.
vec3 evaluateGgx(vec3 normal, vec3 d, vec3 i, float alpha, vec3 reflectance) {
  precise vec3 bisector = i - d;
  precise vec3 h = normalize3(bisector);
  precise float cosOut = -dot3(d, normal);
  precise float cosIn = dot3(i, normal);
  precise float masking = maskingGgx(alpha, cosOut) * maskingGgx(alpha, cosIn);
  precise vec3 across = cross3(h, normal);
  precise float density = distributionGgx(alpha, dot3(h, normal), dot3(across, across));
  precise float above = density * masking;
  precise float below = 4.0f * cosOut;
  precise float factor = divide(above, below);
  precise vec3 reflected = reflectance * factor;
  precise vec3 result = select(cosOut > 0.0f && cosIn > 0.0f, reflected, vec3(0.0f));
  return result;
}

// Phong lobe times cosine towards the unit direction i.
vec3 evaluatePhong(vec3 normal, vec3 d, vec3 i, float exponent, vec3 reflectance) {
  precise float cosIn = greatest(dot3(i, normal), 0.0f);
  precise float lobe = power(dot3(reflect3(d, normal), i), exponent);
  precise vec3 result = reflectance * (((exponent + 2.0f) * kInverseTwoPi) * (lobe * cosIn));
  return result;
}

// All lobes that are not deltas, times cosine, for light that arrives from the unit direction i.
vec3 evaluateReflectance(Reflectance material, vec3 normal, vec3 d, vec3 i) {
  precise float cosIn = greatest(dot3(i, normal), 0.0f);
  precise vec3 result = material.albedo * (kInversePi * cosIn);
  if (kEffectGgx && anyLane(material.lobe == kLobeGgx)) {
    precise vec3 glossy = result + evaluateGgx(normal, d, i, material.alpha, material.specular);
    result = select(material.lobe == kLobeGgx, glossy, result);
  }
  if (kEffectPhong && anyLane(material.lobe == kLobePhong)) {
    precise vec3 glossy =
        result + evaluatePhong(normal, d, i, material.phongExponent, material.specular);
    result = select(material.lobe == kLobePhong, glossy, result);
  }
  return result;
}
