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

/// Record `index` of `count` at a table's first texel, the same one in all lanes. wide.h has the
/// overload for one per lane.
template <class R, int texelCount>
TexelBlock<R, texelCount> fetchRecord(const SceneView& scene, int table, int stride,
                                      std::int32_t index, int /*count*/) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    const std::uint32_t* words =
        scene.words + std::size_t{4} * (static_cast<std::size_t>(index) * stride + table);
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
  const auto block = fetchRecord<R, kSphereTexels>(scene, scene.index.sphereOffset, kSphereTexels, index,
                                            scene.index.sphereCount);
  return {block.floats3(0), block.float4th(0)};
}

template <class R, class Index>
Box<R> fetchBox(const SceneView& scene, Index index) {
  const auto block = fetchRecord<R, kBoxTexels>(scene, scene.index.boxOffset, kBoxTexels, index,
                                            scene.index.boxCount);
  return {block.floats3(0), block.floats3(1)};
}

template <class R, class Index>
OrientedBox<R> fetchOrientedBox(const SceneView& scene, Index index) {
  const auto block = fetchRecord<R, kOrientedBoxTexels>(scene, scene.index.orientedBoxOffset, kOrientedBoxTexels, index,
                                            scene.index.orientedBoxCount);
  return {block.floats3(0), block.floats3(1), block.floats3(2), block.floats3(3),
          block.floats3(4)};
}

template <class R, class Index>
Triangle<R> fetchTriangle(const SceneView& scene, Index index) {
  const auto block = fetchRecord<R, kTriangleTexels>(
      scene, scene.index.triangleOffset, kTriangleTexels, index, scene.index.triangleCount);
  return {block.floats3(0), block.floats3(1), block.floats3(2)};
}

/// Which record of normals a triangle has; below 0 for a flat one.
template <class R>
IntOf<R> fetchSmoothIndex(const SceneView& scene, IntOf<R> triangle) {
  const auto block = fetchRecord<R, 1>(scene, scene.index.triangleOffset, kTriangleTexels, triangle,
                                       scene.index.triangleCount);
  return block.integer(0, 3) - IntOf<R>(1);
}

/// The unit normals at a triangle's vertices, as a triangle.
template <class R>
Triangle<R> fetchNormals(const SceneView& scene, IntOf<R> index) {
  const auto block = fetchRecord<R, kSmoothTexels>(scene, scene.index.smoothOffset, kSmoothTexels,
                                                   index, scene.index.smoothCount);
  return {block.floats3(0), block.floats3(1), block.floats3(2)};
}

template <class R, class Index>
Plane<R> fetchPlane(const SceneView& scene, Index index) {
  const auto block = fetchRecord<R, kPlaneTexels>(scene, scene.index.planeOffset, kPlaneTexels, index,
                                            scene.index.planeCount);
  return {block.floats3(0), block.floats3(1)};
}

template <class R>
PrimitiveInfo<R> fetchPrimitiveInfo(const SceneView& scene, IntOf<R> primitive) {
  const auto block = fetchRecord<R, kInfoTexels>(scene, scene.index.infoOffset, kInfoTexels,
                                                 primitive, scene.index.primitiveCount());
  return {block.floats3(0), block.integer(0, 3)};
}

/// Some consecutive texels of a material's record.
template <class R, int texelCount>
TexelBlock<R, texelCount> fetchMaterialTexels(const SceneView& scene, IntOf<R> material,
                                              int first) {
  return fetchRecord<R, texelCount>(scene, scene.index.materialOffset + first, kMaterialTexels,
                                    material, scene.index.materialCount);
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
  const int table = scene.index.lightOffset;
  const int count = scene.index.lightCount;
  const auto block = fetchRecord<R, kLightTexels>(scene, table, kLightTexels, index, count);
  const auto plain = fetchRecord<float, kLightTexels>(scene, table, kLightTexels, index, count);
  const int kind = plain.integer(2, 0);
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
  const int width = scene.index.environmentWidth;
  const int count = width * scene.index.environmentHeight;
  const auto block = fetchRecord<R, 1>(scene, scene.index.environmentOffset, 1,
                                       y * IntOf<R>(width) + x, count);
  return block.floats3(0);
}

TWINTRACE_KERNEL_END
