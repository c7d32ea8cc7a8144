// Native maths: the functions of math.glsl by the driver's builtins, as people ship them.
#pragma once

#include "number.glsl"

const float kPi = 3.14159265f;
const float kInversePi = 0.318309886f;
const float kTwoPi = 6.28318531f;
const float kInverseTwoPi = 0.159154943f;

float divide(float a, float b) {
  return a / b;
}

vec3 divide(vec3 a, float b) {
  return a / b;
}

float squareRoot(float x) {
  return sqrt(x);
}

float dot3(vec3 a, vec3 b) {
  return dot(a, b);
}

vec3 cross3(vec3 a, vec3 b) {
  return cross(a, b);
}

float length3(vec3 v) {
  return length(v);
}

vec3 normalize3(vec3 v) {
  return normalize(v);
}

vec3 reflect3(vec3 d, vec3 n) {
  return reflect(d, n);
}

struct SinCos {
  float sine;
  float cosine;
};

SinCos sinCosTurns(float u) {
  float angle = kTwoPi * u;
  return SinCos(sin(angle), cos(angle));
}

float sine(float x) {
  return sin(x);
}

float log2Of(float x) {
  return log2(x);
}

float exp2Of(float x) {
  return exp2(x);
}

float power(float x, float y) {
  return x > 0.0f ? pow(x, y) : 0.0f;
}

float arcTangent2(float y, float x) {
  return atan(y, x);
}

float arcCosine(float x) {
  return acos(clampTo(x, -1.0f, 1.0f));
}
