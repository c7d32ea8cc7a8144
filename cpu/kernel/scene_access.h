#pragma once

// Twin of shaders/scene_access.glsl: the only reader of scene data. Index is int where all lanes
// read the same record, IntOf<R> where each reads its own.

#include <utility>

#include "cpu/kernel/scene_view.h"

TWINTRACE_KERNEL_BEGIN

/// Consecutive texels of one record per lane, as bits.
template <class R, int texelCount>
struct TexelBlock {
  UintOf<R> words[4 * texelCount];

  R number(int texel, int component) const { return numberFromBits<R>(words[4 * texel + component]); }
  Vec3<R> floats3(int texel) const {
    return {number(texel, 0), number(texel, 1), number(texel, 2)};
  }
  R float4th(int texel) const { return number(texel, 3); }
  IntOf<R> integer(int texel, int component) const { return toSigned(words[4 * texel + component]); }
};

/// The record at a texel, the same one in all lanes. wide.h has the overload for one per lane.
template <class R, int texelCount>
TexelBlock<R, texelCount> fetchTexels(const SceneView& scene, std::int32_t first) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    const std::uint32_t* words = scene.words + std::size_t{4} * first;
    return TexelBlock<R, texelCount>{{UintOf<R>(words[i])...}};
  }(std::make_index_sequence<4 * texelCount>());
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
  const auto block = fetchTexels<R, kSphereTexels>(
      scene, index * Index(kSphereTexels) + Index(scene.index.sphereOffset));
  return {block.floats3(0), block.float4th(0)};
}

template <class R, class Index>
Box<R> fetchBox(const SceneView& scene, Index index) {
  const auto block = fetchTexels<R, kBoxTexels>(
      scene, index * Index(kBoxTexels) + Index(scene.index.boxOffset));
  return {block.floats3(0), block.floats3(1)};
}

template <class R, class Index>
OrientedBox<R> fetchOrientedBox(const SceneView& scene, Index index) {
  const auto block = fetchTexels<R, kOrientedBoxTexels>(
      scene, index * Index(kOrientedBoxTexels) + Index(scene.index.orientedBoxOffset));
  return {block.floats3(0), block.floats3(1), block.floats3(2), block.floats3(3),
          block.floats3(4)};
}

template <class R, class Index>
Plane<R> fetchPlane(const SceneView& scene, Index index) {
  const auto block = fetchTexels<R, kPlaneTexels>(
      scene, index * Index(kPlaneTexels) + Index(scene.index.planeOffset));
  return {block.floats3(0), block.floats3(1)};
}

template <class R>
PrimitiveInfo<R> fetchPrimitiveInfo(const SceneView& scene, IntOf<R> primitive) {
  using Index = IntOf<R>;
  const auto block = fetchTexels<R, kInfoTexels>(
      scene, primitive * Index(kInfoTexels) + Index(scene.index.infoOffset));
  return {block.floats3(0), block.integer(0, 3)};
}

/// Some consecutive texels of a material's record.
template <class R, int texelCount>
TexelBlock<R, texelCount> fetchMaterialTexels(const SceneView& scene, IntOf<R> material,
                                              int first) {
  return fetchTexels<R, texelCount>(scene, material * IntOf<R>(kMaterialTexels) +
                                               IntOf<R>(scene.index.materialOffset + first));
}

template <class R>
Scattering<R> fetchScattering(const SceneView& scene, IntOf<R> material) {
  const auto block = fetchMaterialTexels<R, 3>(scene, material, 0);
  return {block.floats3(0),   block.floats3(1),   block.float4th(0),   block.number(2, 0),
          block.number(2, 1), block.number(2, 2), block.integer(1, 3)};
}

template <class R>
Reflectance<R> fetchReflectance(const SceneView& scene, IntOf<R> material) {
  const auto block = fetchMaterialTexels<R, 4>(scene, material, 1);
  return {block.floats3(2), block.floats3(3), block.number(1, 0), block.float4th(1),
          block.integer(0, 3)};
}

template <class R>
LocalShading<R> fetchLocalShading(const SceneView& scene, IntOf<R> material) {
  const auto block = fetchMaterialTexels<R, 4>(scene, material, 3);
  return {block.floats3(0), block.floats3(3), block.float4th(3), block.floats3(2)};
}

template <class R>
Light<R> fetchLight(const SceneView& scene, int index) {
  const int first = index * kLightTexels + scene.index.lightOffset;
  const auto block = fetchTexels<R, kLightTexels>(scene, first);
  const int kind = fetchTexels<float, 1>(scene, first + 2).integer(0, 0);
  return {kind, block.floats3(0), block.float4th(0), block.floats3(1), block.float4th(1)};
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
  return fetchTexels<R, 1>(scene, y * Index(scene.index.environmentWidth) + x +
                                      Index(scene.index.environmentOffset))
      .floats3(0);
}

TWINTRACE_KERNEL_END
