// A path under way, and how its first ray leaves the camera.
#pragma once

#include "hash.glsl"
#include "ray.glsl"
#include "sampling.glsl"
#include "scene_access.glsl"

// What is the same for all samples of a frame.
struct Frame {
  int width;         // of the film, pixels
  int bounces;       // scattering events at most
  int passes;        // samples per pixel
  uint firstSample;  // index of the frame's first sample
  uint seed;
};

struct PathState {
  SampleKey key;
  Ray ray;
  vec3 throughput;
  vec3 radiance;
  int bounce;   // scattering events so far
  bool alive;
};

// Ray of a sample: uniform over the pixel, and over the lens if there is one.
Ray cameraRay(int x, int y, SampleKey key) {
  precise Camera camera = fetchCamera();
  precise float column = float(x) + noise(key, 0, kDimensionPixelX);
  precise float row = float(y) + noise(key, 0, kDimensionPixelY);
  precise vec3 target = (camera.corner + camera.stepX * column) + camera.stepY * row;
  precise vec3 origin = camera.origin;
  precise vec3 towards = target;
  if (kEffectLens) {
    precise vec3 disk = sampleDisk(noise(key, 0, kDimensionLensRadius),
                                   noise(key, 0, kDimensionLensAngle));
    precise vec3 shift = camera.lensX * disk.x + camera.lensY * disk.y;
    origin = camera.origin + shift;
    towards = target - shift;
  }
  precise Ray result = makeRay(origin, normalize3(towards), 0.0f, kLargest);
  return result;
}

PathState beginSample(int x, int y, uint sampleIndex, Frame frame) {
  SampleKey key = makeSampleKey(x, y, frame.width, sampleIndex, frame.seed);
  precise Ray ray = cameraRay(x, y, key);
  precise PathState result = PathState(key, ray, vec3(1.0f), vec3(0.0f), 0, true);
  return result;
}

// The normal turned against d.
vec3 facingNormal(vec3 normal, vec3 d) {
  precise float along = dot3(normal, d);
  precise vec3 result = select(along > 0.0f, -normal, normal);
  return result;
}

bool isBlack(vec3 colour) {
  return colour.x == 0.0f && colour.y == 0.0f && colour.z == 0.0f;
}
