#include "common/base/flush_denormals.h"
#include "common/hulls/hull_structure.h"
#include "tests/parity/parity.h"

namespace twintrace::parity {
namespace {

Witness witnessOf(const FlatScene& scene, const RenderOptions& options) {
  Witness w;
  w.sceneTexels = scene.texels;
  w.cameraOrigin = scene.camera.origin;
  w.cameraCorner = scene.camera.corner;
  w.cameraStepX = scene.camera.stepX;
  w.cameraStepY = scene.camera.stepY;
  w.cameraLensX = scene.camera.lensX;
  w.cameraLensY = scene.camera.lensY;
  w.environmentRadiance = scene.environmentRadiance;
  w.environmentTurn = scene.environmentTurn;
  w.kNoiseSine = options.noise == Noise::sine;
  w.kIntersectorReport = options.intersector == Intersector::report;
  w.kIntegrator = static_cast<int>(options.integrator);
  const SceneIndex& index = scene.index;
  w.kSphereCount = index.sphereCount;
  w.kBoxCount = index.boxCount;
  w.kOrientedBoxCount = index.orientedBoxCount;
  w.kTriangleCount = index.triangleCount;
  w.kPlaneCount = index.planeCount;
  w.kLightCount = index.lightCount;
  w.kSphereOffset = index.sphereOffset;
  w.kBoxOffset = index.boxOffset;
  w.kOrientedBoxOffset = index.orientedBoxOffset;
  w.kTriangleOffset = index.triangleOffset;
  w.kSmoothOffset = index.smoothOffset;
  w.kPlaneOffset = index.planeOffset;
  w.kInfoOffset = index.infoOffset;
  w.kMaterialOffset = index.materialOffset;
  w.kLightOffset = index.lightOffset;
  w.kEnvironmentOffset = index.environmentOffset;
  w.kEnvironmentWidth = index.environmentWidth;
  w.kEnvironmentHeight = index.environmentHeight;
  if (scene.hulls == nullptr) return w;
  w.hullTexels = scene.hulls->texels;
  w.hullReach = scene.hulls->reach;
  w.kHullGroups = scene.hulls->volume.groups;
  w.kHullNodeTexels = scene.hulls->nodeTexels;
  w.kHullNodeCount = scene.hulls->nodeCount;
  w.kHullReferenceOffset = scene.hulls->referenceOffset;
  return w;
}

}  // namespace

std::vector<std::uint32_t> runWitness(const ShaderFunction& function, WitnessCall call,
                                      const World& world, std::span<const std::uint32_t> inputs) {
  const FlushDenormals flush;
  Witness witness = witnessOf(world.scene, world.options);
  const auto in = static_cast<std::size_t>(inputWords(function));
  const auto out = static_cast<std::size_t>(outputWords(function));
  std::vector<std::uint32_t> results(inputs.size() / in * out);
  for (std::size_t i = 0; i * in < inputs.size(); ++i) {
    call(witness, &inputs[i * in], &results[i * out]);
  }
  return results;
}

}  // namespace twintrace::parity
