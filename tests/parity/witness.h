#pragma once

// The third witness: the text of the shaders compiled as C++ through GLM.
//
// Where GPU and twin differ, it tells apart the arithmetic of the GL (the witness agrees with the
// twin: same text, other machine) from logic (the witness agrees with the GPU: same text, same
// answer). The shaders are included inside a structure, so that what a GL program takes as
// specialisation constants and uniforms are its members and every witness has its own.

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <stdexcept>

#include "common/scene/layout.h"

namespace twintrace::parity {

using namespace glm;
using namespace twintrace::layout;

#define precise

struct Witness {
  std::span<const uvec4> sceneTexels, hullTexels;
  float hullReach = 0.0f;
  vec3 cameraOrigin, cameraCorner, cameraStepX, cameraStepY, cameraLensX, cameraLensY;
  vec3 environmentRadiance;
  float environmentTurn = 0.0f;

  bool kEffectSphere = true, kEffectBox = true, kEffectOrientedBox = true, kEffectPlane = true;
  bool kEffectTriangle = true, kEffectSmooth = true;
  bool kEffectEmission = true, kEffectDiffuse = true, kEffectMirror = true, kEffectGgx = true;
  bool kEffectPhong = true, kEffectEnvironmentImage = true, kEffectPointLight = true;
  bool kEffectSphereLight = true, kEffectSunLight = true, kEffectLens = true;
  bool kEffectIndirect = true;
  bool kCorrectedDivision = false, kCorrectedRoot = false;
  bool kNoiseSine = false, kIntersectorReport = false;
  int kIntegrator = 0;
  int kSphereCount = 0, kBoxCount = 0, kOrientedBoxCount = 0, kPlaneCount = 0, kLightCount = 0;
  int kTriangleCount = 0, kTriangleOffset = 0, kSmoothOffset = 0;
  int kSphereOffset = 0, kBoxOffset = 0, kOrientedBoxOffset = 0, kPlaneOffset = 0;
  int kInfoOffset = 0, kMaterialOffset = 0, kLightOffset = 0;
  int kHullGroups = 1, kHullNodeTexels = 0, kHullNodeCount = 0, kHullReferenceOffset = 0;
  int kEnvironmentOffset = 0, kEnvironmentWidth = 0, kEnvironmentHeight = 0;

  // GLM's is a selection that leaves the sign of a denormal where denormals are zero.
  static float abs(float x) { return std::fabs(x); }

  static uvec4 texelFetch(std::span<const uvec4> texels, int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= texels.size()) {
      throw std::out_of_range("texelFetch");
    }
    return texels[static_cast<std::size_t>(index)];
  }

#include "all_shaders.h"
};

#undef precise

}  // namespace twintrace::parity
