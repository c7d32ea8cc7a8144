// The dialect that all shader code and its C++ twins share: selection instead of branches, minimum
// and maximum with a stated treatment of NaN. A lane is one ray; in GLSL a value is a single lane.
#pragma once

#include "shared/layout.glsl"

const float kInfinity = uintBitsToFloat(0x7f800000u);
const float kLargest = 3.402823466e38f;

bool anyLane(bool condition) {
  return condition;
}

float select(precise bool condition, float a, float b) {
  precise float result = condition ? a : b;
  return result;
}

int select(precise bool condition, int a, int b) {
  return condition ? a : b;
}

uint select(precise bool condition, uint a, uint b) {
  return condition ? a : b;
}

vec3 select(precise bool condition, vec3 a, vec3 b) {
  precise vec3 result = condition ? a : b;
  return result;
}

// The smaller value; a NaN in b is dropped, a NaN in a stays.
float least(float a, float b) {
  precise bool smaller = b < a;
  precise float result = smaller ? b : a;
  return result;
}

// The larger value; a NaN in b is dropped, a NaN in a stays.
float greatest(float a, float b) {
  precise bool larger = b > a;
  precise float result = larger ? b : a;
  return result;
}

// x held within [low, high]; NaN becomes low.
float clampTo(float x, float low, float high) {
  precise float raised = greatest(low, x);
  precise float result = least(raised, high);
  return result;
}

float absolute(float x) {
  precise float result = abs(x);
  return result;
}

float largestComponent(vec3 v) {
  precise float xy = greatest(v.x, v.y);
  precise float result = greatest(xy, v.z);
  return result;
}
