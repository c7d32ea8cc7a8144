// The records of a flat scene as structures. Layout in memory: shared/layout.glsl.
#pragma once

struct Camera {
  vec3 origin;
  vec3 corner;  // from the origin to the film's top left corner on the focal plane
  vec3 stepX;   // one pixel right
  vec3 stepY;   // one pixel down
  vec3 lensX;   // lens axes, as long as the lens radius
  vec3 lensY;
};

struct Sphere {
  vec3 center;
  float radius;
};

struct Box {
  vec3 minimum;
  vec3 maximum;
};

struct OrientedBox {
  vec3 center;
  vec3 axisX;
  vec3 axisY;
  vec3 axisZ;
  vec3 halfSize;
};

struct Plane {
  vec3 point;
  vec3 normal;
};

struct Triangle {
  vec3 a;
  vec3 b;
  vec3 c;
};

// What every hit needs: the emission of the primitive's material stands here so that most hits read
// one texel only.
struct PrimitiveInfo {
  vec3 emission;
  int material;
};

// What sampling a material's lobes needs. Weights are reflectances divided by the chance of the
// lobe, so that no division is left to the tracer.
struct Scattering {
  vec3 albedoWeight;
  vec3 specularWeight;
  float specularChance;
  float alpha;         // GGX: roughness squared
  float phongScale;    // Phong: (exponent + 2) / (exponent + 1)
  float phongInverse;  // Phong: 1 / (exponent + 1)
  int lobe;
};

// What evaluating a material towards a light needs.
struct Reflectance {
  vec3 albedo;
  vec3 specular;
  float alpha;
  float phongExponent;
  int lobe;
};

// What the local model, eq. 1, needs.
struct LocalShading {
  vec3 albedo;     // k_df
  vec3 highlight;  // k_s
  float exponent;  // alpha
  vec3 ambient;    // k_a
};

struct Light {
  int kind;
  vec3 position;   // sun: unit direction towards the sun
  float radius;    // sphere
  vec3 radiance;   // sphere: radiance; point: intensity; sun: radiance times solid angle
  float height;    // sun: 1 - cos of the angular radius
};
