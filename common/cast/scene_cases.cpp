#include "common/cast/scene_cases.h"

#include <bit>

#include "common/scene/layout.h"

namespace twintrace {
namespace {

/// Fills a primitive's values from the components of texels, in order.
class Filler {
 public:
  Filler(const FlatScene& scene, CasePrimitive& primitive) : scene_(scene), primitive_(primitive) {}

  void add(int texel, int components = 3) {
    for (int i = 0; i < components; ++i) {
      const std::uint32_t word = scene_.texels[static_cast<std::size_t>(texel)][i];
      primitive_.values[static_cast<std::size_t>(filled_++)] = std::bit_cast<float>(word);
    }
  }

 private:
  const FlatScene& scene_;
  CasePrimitive& primitive_;
  int filled_ = 0;
};

CasePrimitive casePrimitive(const FlatScene& scene, CaseKind kind, int texel) {
  CasePrimitive primitive{kind, {}};
  Filler filler(scene, primitive);
  switch (kind) {
    case CaseKind::sphere:
      filler.add(texel, 4);
      break;
    case CaseKind::plane:  // whose texels have the point first
      filler.add(texel + 1);
      filler.add(texel);
      break;
    case CaseKind::box:
      for (int i = 0; i < layout::kBoxTexels; ++i) filler.add(texel + i);
      break;
    case CaseKind::orientedBox:
      for (int i = 0; i < layout::kOrientedBoxTexels; ++i) filler.add(texel + i);
      break;
    case CaseKind::triangle:
      for (int i = 0; i < layout::kTriangleTexels; ++i) filler.add(texel + i);
      break;
  }
  return normalised(primitive);
}

void addTable(CaseSet& cases, const FlatScene& scene, CaseKind kind, int offset, int count,
              int stride) {
  for (int i = 0; i < count; ++i) {
    const std::size_t primitive = cases.primitives.size();
    cases.primitives.push_back(casePrimitive(scene, kind, offset + i * stride));
    const auto object = static_cast<std::size_t>(scene.primitiveObject[primitive]);
    cases.primitiveNames.push_back(scene.objectNames[object]);
  }
}

}  // namespace

CaseSet casesOf(const FlatScene& scene, std::span<const CastRay> rays) {
  const SceneIndex& index = scene.index;
  CaseSet cases;
  addTable(cases, scene, CaseKind::sphere, index.sphereOffset, index.sphereCount,
           layout::kSphereTexels);
  addTable(cases, scene, CaseKind::box, index.boxOffset, index.boxCount, layout::kBoxTexels);
  addTable(cases, scene, CaseKind::orientedBox, index.orientedBoxOffset, index.orientedBoxCount,
           layout::kOrientedBoxTexels);
  addTable(cases, scene, CaseKind::triangle, index.triangleOffset, index.triangleCount,
           layout::kTriangleTexels);
  addTable(cases, scene, CaseKind::plane, index.planeOffset, index.planeCount,
           layout::kPlaneTexels);
  cases.scenes.push_back({0, static_cast<std::uint32_t>(cases.primitives.size())});
  cases.rays.reserve(rays.size());
  for (const CastRay& ray : rays) cases.rays.push_back({ray, 0});
  return cases;
}

}  // namespace twintrace
