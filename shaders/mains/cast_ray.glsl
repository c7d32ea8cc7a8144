// What the cast mains share: rays of cases and their answers.
#pragma once

#include "mains/uniforms.glsl"

#include "cases.glsl"

uniform usamplerBuffer rayTexels;  // see kCaseRayTexels
uniform int rayCount;

CaseAnswer castRay(int index) {
  uvec4 first = texelFetch(rayTexels, index * kCaseRayTexels);
  uvec4 second = texelFetch(rayTexels, index * kCaseRayTexels + 1);
  uvec4 third = texelFetch(rayTexels, index * kCaseRayTexels + 2);
  uvec4 fourth = texelFetch(rayTexels, index * kCaseRayTexels + 3);
  precise CaseQuery query =
      CaseQuery(floats3(first), floats3(second), float4th(first), float4th(second),
                uintBitsToFloat(third.z), int(third.x), int(third.y));
  precise vec3 random = floats3(fourth);
  precise CaseAnswer result = CaseAnswer(0.0f, kCaseMiss, vec3(0.0f));
  if (third.w != 0u) {
    result = castBounce(query, random.x, random.y);
  } else {
    result = castQuery(query);
  }
  return result;
}
