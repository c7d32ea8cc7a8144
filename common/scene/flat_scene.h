#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "common/scene/effects.h"
#include "common/scene/scene.h"

namespace twintrace {

struct HullStructure;

/// The camera as the tracers read it. A sample at film position (x, y) in pixels, row 0 on top,
/// looks from `origin` at the point `origin + corner + x * stepX + y * stepY` of the focal plane.
struct FlatCamera {
  glm::vec3 origin{0.0f};
  glm::vec3 corner{0.0f};
  glm::vec3 stepX{0.0f};
  glm::vec3 stepY{0.0f};
  glm::vec3 lensX{0.0f};  ///< lens axes, as long as the lens radius
  glm::vec3 lensY{0.0f};
};

/// Where each kind of record lies in the texels, and how many there are. Primitives are numbered
/// through spheres, boxes, oriented boxes, triangles and planes, in scene order within each kind: those
/// with bounds come first.
struct SceneIndex {
  int sphereCount = 0;
  int boxCount = 0;
  int orientedBoxCount = 0;
  int triangleCount = 0;
  int planeCount = 0;
  int smoothCount = 0;
  int lightCount = 0;
  int materialCount = 0;
  int sphereOffset = 0;
  int boxOffset = 0;
  int orientedBoxOffset = 0;
  int triangleOffset = 0;
  int smoothOffset = 0;  ///< normals of smooth triangles
  int planeOffset = 0;
  int infoOffset = 0;
  int materialOffset = 0;
  int lightOffset = 0;
  int environmentOffset = 0;  ///< texels of the image, row by row, alpha unused
  int environmentWidth = 0;   ///< 0 = constant environment
  int environmentHeight = 0;

  int boundedCount() const { return sphereCount + boxCount + orientedBoxCount + triangleCount; }
  int primitiveCount() const { return boundedCount() + planeCount; }
};

/// The immutable arrays that tracers read. Layout of the records: shaders/shared/layout.glsl.
struct FlatScene {
  int width = 0;
  int height = 0;
  FlatCamera camera;
  SceneIndex index;
  std::vector<glm::uvec4> texels;
  glm::vec3 environmentRadiance{0.0f};  ///< constant environment, L_a of eq. 1 too
  float environmentTurn = 0.0f;         ///< rotation about y, in turns
  std::vector<int> primitiveObject;     ///< object of each primitive
  std::vector<std::string> objectNames;
  EffectSet effects;                    ///< compiled in
  std::shared_ptr<const HullStructure> hulls;  ///< null: every primitive is tested, or Embree asked
};

/// Resolves a scene under options into arrays; loads the environment image.
/// @throws FileError if the image can't be read, UsageError for sizes out of range.
FlatScene flatten(const Scene& scene, const RenderOptions& options);

/// Hash of everything in the flat scene that determines a picture, as 32 hex digits (XXH3-128).
std::string sceneHash(const FlatScene& scene);

}  // namespace twintrace
