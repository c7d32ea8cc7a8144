// What the hull caster's mains share: rays and their closest hits.
#pragma once

#include "mains/uniforms.glsl"

#include "hulls/walks/hull_counts.glsl"
#include "mains/loop_check.glsl"
#include "traverse.glsl"

uniform usamplerBuffer rayTexels;  // origin, tmin; direction, tmax
uniform int rayCount;

Hit queryRay(int index) {
  uvec4 first = texelFetch(rayTexels, 2 * index);
  uvec4 second = texelFetch(rayTexels, 2 * index + 1);
  precise Ray ray = makeRay(floats3(first), floats3(second), float4th(first), float4th(second));
  precise Hit result = closestHit(ray);
  if (!loopsHeld()) {
    result.t = uintBitsToFloat(0x7fc00000u);  // NaN, which no hit has
  }
  return result;
}
