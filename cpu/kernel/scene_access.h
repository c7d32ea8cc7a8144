#pragma once

// Twin of shaders/scene_access.glsl: the only reader of scene data. Index is int where all lanes
// read the same record, IntOf<R> where each reads its own.

#include "cpu/kernel/scene_view.h"

TWINTRACE_KERNEL_BEGIN

/// Word `component` (0..3) of a texel as a number. wide.h has the overload for an index per lane.
template <class R>
R fetchNumber(const SceneView& scene, std::int32_t texel, int component) {
  return R(std::bit_cast<float>(scene.words[std::size_t{4} * texel + component]));
}

template <class R>
std::int32_t fetchInteger(const SceneView& scene, std::int32_t texel, int component) {
  return static_cast<std::int32_t>(scene.words[std::size_t{4} * texel + component]);
}

template <class R, class Index>
Vec3<R> floats3(const SceneView& scene, Index texel) {
  return {fetchNumber<R>(scene, texel, 0), fetchNumber<R>(scene, texel, 1),
          fetchNumber<R>(scene, texel, 2)};
}

template <class R, class Index>
R float4th(const SceneView& scene, Index texel) {
  return fetchNumber<R>(scene, texel, 3);
}

template <class R>
Vec3<R> widenedVector(const Vec3<float>& v) {
  return {R(v.x), R(v.y), R(v.z)};
}

template <class R>
Camera<R> fetchCamera(const SceneView& scene) {
  const Camera<float>& c = scene.camera;
  return {widenedVector<R>(c.origin), widenedVector<R>(c.corner), widenedVector<R>(c.stepX),
          widenedVector<R>(c.stepY),  widenedVector<R>(c.lensX),  widenedVector<R>(c.lensY)};
}

template <class R, class Index>
Sphere<R> fetchSphere(const SceneView& scene, Index index) {
  const Index at = index * Index(kSphereTexels) + Index(scene.index.sphereOffset);
  return {floats3<R>(scene, at), float4th<R>(scene, at)};
}

template <class R, class Index>
Box<R> fetchBox(const SceneView& scene, Index index) {
  const Index at = index * Index(kBoxTexels) + Index(scene.index.boxOffset);
  return {floats3<R>(scene, at), floats3<R>(scene, at + Index(1))};
}

template <class R, class Index>
OrientedBox<R> fetchOrientedBox(const SceneView& scene, Index index) {
  const Index at = index * Index(kOrientedBoxTexels) + Index(scene.index.orientedBoxOffset);
  return {floats3<R>(scene, at), floats3<R>(scene, at + Index(1)), floats3<R>(scene, at + Index(2)),
          floats3<R>(scene, at + Index(3)), floats3<R>(scene, at + Index(4))};
}

template <class R, class Index>
Plane<R> fetchPlane(const SceneView& scene, Index index) {
  const Index at = index * Index(kPlaneTexels) + Index(scene.index.planeOffset);
  return {floats3<R>(scene, at), floats3<R>(scene, at + Index(1))};
}

template <class R>
IntOf<R> fetchMaterialIndex(const SceneView& scene, IntOf<R> primitive) {
  using Index = IntOf<R>;
  return fetchInteger<R>(scene, primitive * Index(kInfoTexels) + Index(scene.index.infoOffset), 0);
}

/// First texel of a material.
template <class R>
IntOf<R> materialTexel(const SceneView& scene, IntOf<R> material) {
  return material * IntOf<R>(kMaterialTexels) + IntOf<R>(scene.index.materialOffset);
}

template <class R>
Vec3<R> fetchEmission(const SceneView& scene, IntOf<R> material) {
  return floats3<R>(scene, materialTexel<R>(scene, material) + IntOf<R>(2));
}

template <class R>
Scattering<R> fetchScattering(const SceneView& scene, IntOf<R> material) {
  using Index = IntOf<R>;
  const Index at = materialTexel<R>(scene, material);
  return {floats3<R>(scene, at),
          floats3<R>(scene, at + Index(1)),
          float4th<R>(scene, at),
          float4th<R>(scene, at + Index(1)),
          float4th<R>(scene, at + Index(4)),
          float4th<R>(scene, at + Index(5)),
          fetchInteger<R>(scene, at + Index(2), 3)};
}

template <class R>
Reflectance<R> fetchReflectance(const SceneView& scene, IntOf<R> material) {
  using Index = IntOf<R>;
  const Index at = materialTexel<R>(scene, material);
  return {floats3<R>(scene, at + Index(3)), floats3<R>(scene, at + Index(4)),
          float4th<R>(scene, at + Index(1)), float4th<R>(scene, at + Index(3)),
          fetchInteger<R>(scene, at + Index(2), 3)};
}

template <class R>
LocalShading<R> fetchLocalShading(const SceneView& scene, IntOf<R> material) {
  using Index = IntOf<R>;
  const Index at = materialTexel<R>(scene, material);
  return {floats3<R>(scene, at + Index(3)), floats3<R>(scene, at + Index(6)),
          float4th<R>(scene, at + Index(6)), floats3<R>(scene, at + Index(5))};
}

template <class R>
Light<R> fetchLight(const SceneView& scene, int index) {
  const int at = index * kLightTexels + scene.index.lightOffset;
  return {fetchInteger<float>(scene, at + 2, 0), floats3<R>(scene, at), float4th<R>(scene, at),
          floats3<R>(scene, at + 1), float4th<R>(scene, at + 1)};
}

template <class R>
Vec3<R> fetchEnvironmentRadiance(const SceneView& scene) {
  return widenedVector<R>(scene.environmentRadiance);
}

template <class R>
R fetchEnvironmentTurn(const SceneView& scene) {
  return R(scene.environmentTurn);
}

template <class R>
Vec3<R> fetchEnvironmentPixel(const SceneView& scene, IntOf<R> x, IntOf<R> y) {
  using Index = IntOf<R>;
  return floats3<R>(scene, y * Index(scene.index.environmentWidth) + x +
                               Index(scene.index.environmentOffset));
}

TWINTRACE_KERNEL_END
