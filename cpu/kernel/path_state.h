#pragma once

// Twin of shaders/path_state.glsl: a path under way, and how its first ray leaves the camera.

#include "cpu/kernel/hash.h"
#include "cpu/kernel/ray.h"
#include "cpu/kernel/sampling.h"
#include "cpu/kernel/scene_access.h"

TWINTRACE_KERNEL_BEGIN

/// What is the same for all samples of a frame.
struct Frame {
  int width;                  ///< of the film, pixels
  int bounces;                ///< scattering events at most
  int passes;                 ///< samples per pixel
  std::uint32_t firstSample;  ///< index of the frame's first sample
  std::uint32_t seed;
};

template <class R>
struct PathState {
  SampleKey<R> key;
  Ray<R> ray;
  Vec3<R> throughput;
  Vec3<R> radiance;
  IntOf<R> bounce;  ///< scattering events so far
  MaskOf<R> alive;
};

/// Ray of a sample: uniform over the pixel, and over the lens if there is one.
template <class R>
Ray<R> cameraRay(const SceneView& scene, IntOf<R> x, IntOf<R> y, const SampleKey<R>& key) {
  using Int = IntOf<R>;
  const Camera<R> camera = fetchCamera<R>(scene);
  const R column = toNumber<R>(x) + noise<R>(scene, key, Int(0), kDimensionPixelX);
  const R row = toNumber<R>(y) + noise<R>(scene, key, Int(0), kDimensionPixelY);
  const Vec3<R> target = (camera.corner + camera.stepX * column) + camera.stepY * row;
  Vec3<R> origin = camera.origin;
  Vec3<R> towards = target;
  if (scene.effectLens) {
    const Vec3<R> disk = sampleDisk(noise<R>(scene, key, Int(0), kDimensionLensRadius),
                                    noise<R>(scene, key, Int(0), kDimensionLensAngle));
    const Vec3<R> shift = camera.lensX * disk.x + camera.lensY * disk.y;
    origin = camera.origin + shift;
    towards = target - shift;
  }
  return makeRay(origin, normalize3(towards), R(0.0f), R(kLargest));
}

template <class R>
PathState<R> beginSample(const SceneView& scene, IntOf<R> x, IntOf<R> y, UintOf<R> sampleIndex,
                         const Frame& frame) {
  const SampleKey<R> key =
      makeSampleKey<R>(scene, x, y, frame.width, sampleIndex, frame.seed);
  const Ray<R> ray = cameraRay<R>(scene, x, y, key);
  return {key, ray, Vec3<R>(R(1.0f)), Vec3<R>(), IntOf<R>(0), MaskOf<R>(true)};
}

/// The normal turned against d.
template <class R>
Vec3<R> facingNormal(const Vec3<R>& normal, const Vec3<R>& d) {
  return select(dot3(normal, d) > R(0.0f), -normal, normal);
}

template <class R>
MaskOf<R> isBlack(const Vec3<R>& colour) {
  return colour.x == R(0.0f) && colour.y == R(0.0f) && colour.z == R(0.0f);
}

TWINTRACE_KERNEL_END
