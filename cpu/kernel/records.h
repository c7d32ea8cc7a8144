#pragma once

// Twin of shaders/records.glsl: the records of a flat scene as structures.

#include "cpu/kernel/number.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
struct Camera {
  Vec3<R> origin;
  Vec3<R> corner;
  Vec3<R> stepX;
  Vec3<R> stepY;
  Vec3<R> lensX;
  Vec3<R> lensY;
};

template <class R>
struct Sphere {
  Vec3<R> center;
  R radius;
};

template <class R>
struct Box {
  Vec3<R> minimum;
  Vec3<R> maximum;
};

template <class R>
struct OrientedBox {
  Vec3<R> center;
  Vec3<R> axisX;
  Vec3<R> axisY;
  Vec3<R> axisZ;
  Vec3<R> halfSize;
};

template <class R>
struct Plane {
  Vec3<R> point;
  Vec3<R> normal;
};

template <class R>
struct Triangle {
  Vec3<R> a;
  Vec3<R> b;
  Vec3<R> c;
};

/// What every hit needs: the emission of the primitive's material, and which one it is.
template <class R>
struct PrimitiveInfo {
  Vec3<R> emission;
  IntOf<R> material;
};

/// What sampling a material's lobes needs; weights are reflectances over the chance of the lobe.
template <class R>
struct Scattering {
  Vec3<R> albedoWeight;
  Vec3<R> specularWeight;
  R specularChance;
  R alpha;
  R phongScale;
  R phongInverse;
  IntOf<R> lobe;
};

/// What evaluating a material towards a light needs.
template <class R>
struct Reflectance {
  Vec3<R> albedo;
  Vec3<R> specular;
  R alpha;
  R phongExponent;
  IntOf<R> lobe;
};

/// What the local model, eq. 1, needs.
template <class R>
struct LocalShading {
  Vec3<R> albedo;
  Vec3<R> highlight;
  R exponent;
  Vec3<R> ambient;
};

/// Lights are looped over, the same one in all lanes.
template <class R>
struct Light {
  int kind;
  Vec3<R> position;
  R radius;
  Vec3<R> radiance;
  R height;
};

TWINTRACE_KERNEL_END
