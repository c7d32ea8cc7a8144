#include "gpu/specialisation.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/hulls/hull_structure.h"
#include "common/scene/layout.h"

namespace twintrace {
namespace {

static_assert(static_cast<int>(Integrator::local) == layout::kIntegratorLocal &&
              static_cast<int>(Integrator::whitted) == layout::kIntegratorWhitted &&
              static_cast<int>(Integrator::report) == layout::kIntegratorReport &&
              static_cast<int>(Integrator::path) == layout::kIntegratorPath);

std::string constant(std::string_view type, std::string_view name, std::string_view value) {
  return fmt::format("const {} {} = {};\n", type, name, value);
}

std::string boolConstant(std::string_view name, bool value) {
  return constant("bool", name, value ? "true" : "false");
}

std::string capitalised(std::string_view name) {
  std::string result(name);
  result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
  return result;
}

std::string effectConstants(const EffectSet& effects) {
  std::string text;
  for (int i = 0; i < kEffectCount; ++i) {
    text += boolConstant("kEffect" + capitalised(kEffectNames[i]),
                         effects.has(static_cast<Effect>(i)));
  }
  return text;
}

std::string indexText(const FlatScene& scene, bool uniforms) {
  std::string text;
  for (const auto& [name, value] : indexConstants(scene)) {
    text += uniforms ? fmt::format("uniform int {};\n", name)
                     : constant("int", name, std::to_string(value));
  }
  return text;
}

std::string hullConstants(const FlatScene& scene, bool counting) {
  const int groups = scene.hulls == nullptr ? 1 : scene.hulls->volume.groups;
  return constant("int", "kHullGroups", std::to_string(groups)) +
         boolConstant("kHullCounting", counting);
}

// Floats as bit patterns: exact, and no driver's parser between them and the scene.
std::string literal(const glm::uvec4& texel) {
  return fmt::format("vec3(uintBitsToFloat(0x{:08x}u), uintBitsToFloat(0x{:08x}u), "
                     "uintBitsToFloat(0x{:08x}u))",
                     texel.x, texel.y, texel.z);
}

class LiteralGeometry {
 public:
  explicit LiteralGeometry(const FlatScene& scene) : scene_(scene) {}

  std::string text() {
    const SceneIndex& index = scene_.index;
    kind(Effect::sphere, index.sphereCount, index.sphereOffset, layout::kSphereTexels, "Sphere");
    kind(Effect::box, index.boxCount, index.boxOffset, layout::kBoxTexels, "Box");
    kind(Effect::orientedBox, index.orientedBoxCount, index.orientedBoxOffset,
         layout::kOrientedBoxTexels, "OrientedBox");
    kind(Effect::triangle, index.triangleCount, index.triangleOffset, layout::kTriangleTexels,
         "Triangle");
    kind(Effect::plane, index.planeCount, index.planeOffset, layout::kPlaneTexels, "Plane");
    return "// Generated: this scene's geometry as literals.\n#pragma once\n\n"
           "#include \"intersect.glsl\"\n#include \"scene_access.glsl\"\n\n" +
           lookups_ + "Hit visitGeometry(Ray ray, Hit start) {\n  precise Hit best = start;\n" +
           calls_ + "  return best;\n}\n";
  }

 private:
  void kind(Effect effect, int count, int offset, int texels, std::string_view type) {
    lookups_ += fmt::format("{} visited{}(int index) {{\n", type, type);
    const bool compiled = count > 0 && scene_.effects.has(effect);
    if (!compiled) lookups_ += fmt::format("  return fetch{}(index);\n}}\n\n", type);
    for (int i = 0; i < count; ++i, ++primitive_) {
      if (!compiled) continue;
      const std::string record = fmt::format("{}({})", type, arguments(offset + i * texels, texels));
      calls_ += fmt::format("  best = nearer(best, intersect{}(ray, {}), {});\n", type, record,
                            primitive_);
      lookups_ += i == 0 ? fmt::format("  precise {} result = {};\n", type, record)
                         : fmt::format("  if (index == {}) {{\n    result = {};\n  }}\n", i, record);
    }
    if (compiled) lookups_ += "  return result;\n}\n\n";
  }

  // A sphere's radius is its texel's fourth float; the other records are vectors only.
  std::string arguments(int at, int texels) const {
    std::string text = literal(scene_.texels[at]);
    if (texels == layout::kSphereTexels) {
      text += fmt::format(", uintBitsToFloat(0x{:08x}u)", scene_.texels[at].w);
    }
    for (int i = 1; i < texels; ++i) text += ", " + literal(scene_.texels[at + i]);
    return text;
  }

  const FlatScene& scene_;
  std::string calls_;
  std::string lookups_;
  int primitive_ = 0;
};

constexpr const char* kGeometryFile = "geometry.glsl";

constexpr const char* kHullFile = "hulls/chosen_hull.glsl";

std::string_view walkName(HullArrangement arrangement) {
  switch (arrangement) {
    case HullArrangement::flat:
      return "flat";
    case HullArrangement::heap:
      return "heap";
    case HullArrangement::tree:
    case HullArrangement::wide:
    case HullArrangement::none:
      break;
  }
  return "tree";
}

std::string walkText(const HullStructure& hulls) {
  const std::string_view walk = walkName(hulls.arrangement);
  return fmt::format("// Generated: this scene's planes, then the walk through its hulls.\n"
                     "#pragma once\n\n#include \"geometry.glsl\"\n#include \"hulls/walks/{}.glsl\"\n\n"
                     "Hit visitScene(Ray ray, Hit start) {{\n"
                     "  precise Hit planes = visitPlanes(ray, start);\n"
                     "  precise Hit result = visit{}(ray, planes);\n  return result;\n}}\n",
                     walk, capitalised(walk));
}

std::string hullText(const HullStructure& hulls) {
  return fmt::format("// Generated: the test of this scene's hulls.\n#pragma once\n\n"
                     "#include \"hulls/volumes/{}.glsl\"\n\n"
                     "float enterHull(HullRay ray, int record) {{\n"
                     "  precise float result = enter{}(ray, record);\n  return result;\n}}\n",
                     hulls.volume.name, capitalised(hulls.volume.name));
}

bool overridesGeometry(const RenderOptions& options) {
  return std::ranges::find(options.shaderOverrides, kGeometryFile, &ShaderReplacement::shader) !=
         options.shaderOverrides.end();
}

}  // namespace

void refuseCpuOptions(const RenderOptions& options) {
  if (options.precision == Precision::float64) {
    throw UsageError("precision double with backend gpu, expected backend cpu: shaders compute in "
                     "float");
  }
  if (options.hull == "bvh8") {
    throw UsageError("hull bvh8 with backend gpu, expected hull bvh: wide nodes are the C++ tracer's");
  }
  if (options.hull == "embree") {
    throw UsageError("hull embree with backend gpu, expected backend cpu: Embree runs there only");
  }
}

bool usesLiteralGeometry(const FlatScene& scene, const RenderOptions& options) {
  const int count = scene.index.primitiveCount();
  if (options.geometry == Geometry::buffer) return false;
  if (options.geometry == Geometry::literal && scene.hulls != nullptr) {
    throw UsageError(fmt::format(
        "found geometry literal with hull {}, expected hull none: hulls refer to the texel array",
        scene.hulls->strategy));
  }
  if (scene.hulls != nullptr) return false;
  if (options.geometry == Geometry::literal && count > kMaxLiteralPrimitives) {
    throw UsageError(fmt::format("geometry literal with {} primitives, expected at most {}", count,
                                 kMaxLiteralPrimitives));
  }
  if (options.geometry == Geometry::literal && overridesGeometry(options)) {
    throw UsageError(fmt::format(
        "found geometry literal with an override of shaders/{}, expected geometry buffer: "
        "literals take that file's place",
        kGeometryFile));
  }
  // Somebody who works on the shaders wants to see the file geometry.glsl at work.
  const bool worksOnGeometry = !options.shaderDirectory.empty() || overridesGeometry(options);
  if (options.geometry == Geometry::automatic && worksOnGeometry) return false;
  return count <= kMaxLiteralPrimitives;
}

bool usesUniformIndex(const FlatScene& scene, const RenderOptions& options) {
  return scene.effects == EffectSet::all() && !usesLiteralGeometry(scene, options);
}

std::vector<std::pair<std::string, int>> indexConstants(const FlatScene& scene) {
  const SceneIndex& index = scene.index;
  const HullStructure none{};
  const HullStructure& hulls = scene.hulls == nullptr ? none : *scene.hulls;
  return {{"kSphereCount", index.sphereCount},
          {"kBoxCount", index.boxCount},
          {"kOrientedBoxCount", index.orientedBoxCount},
          {"kTriangleCount", index.triangleCount},
          {"kPlaneCount", index.planeCount},
          {"kLightCount", index.lightCount},
          {"kSphereOffset", index.sphereOffset},
          {"kBoxOffset", index.boxOffset},
          {"kOrientedBoxOffset", index.orientedBoxOffset},
          {"kTriangleOffset", index.triangleOffset},
          {"kSmoothOffset", index.smoothOffset},
          {"kPlaneOffset", index.planeOffset},
          {"kInfoOffset", index.infoOffset},
          {"kMaterialOffset", index.materialOffset},
          {"kLightOffset", index.lightOffset},
          {"kEnvironmentOffset", index.environmentOffset},
          {"kEnvironmentWidth", index.environmentWidth},
          {"kEnvironmentHeight", index.environmentHeight},
          {"kHullNodeTexels", hulls.nodeTexels},
          {"kHullNodeCount", hulls.nodeCount},
          {"kHullReferenceOffset", hulls.referenceOffset}};
}

ShaderLibrary shaderLibrary(const RenderOptions& options) {
  ShaderLibrary::Overrides overrides;
  for (const ShaderReplacement& replacement : options.shaderOverrides) {
    overrides[replacement.shader] = {replacement.text, replacement.file};
  }
  return ShaderLibrary(options.shaderDirectory, overrides);
}

std::string correctionConstants(const Corrections& corrections) {
  return boolConstant("kCorrectedDivision", corrections.division) +
         boolConstant("kCorrectedRoot", corrections.root);
}

ShaderRequest specialise(const FlatScene& scene, const RenderOptions& options,
                         const Corrections& corrections, bool countHulls) {
  ShaderRequest request;
  request.main =
      options.stage == Stage::fragment ? "mains/fragment.glsl" : "mains/compute.glsl";
  request.prelude =
      correctionConstants(corrections) + effectConstants(scene.effects) +
      boolConstant("kNoiseSine", options.noise == Noise::sine) +
      boolConstant("kIntersectorReport", options.intersector == Intersector::report) +
      constant("int", "kIntegrator", std::to_string(static_cast<int>(options.integrator))) +
      hullConstants(scene, countHulls) +
      indexText(scene, usesUniformIndex(scene, options));
  if (usesLiteralGeometry(scene, options)) {
    request.virtualFiles[kGeometryFile] = LiteralGeometry(scene).text();
  }
  if (scene.hulls != nullptr) {
    request.virtualFiles[kWalkFile] = walkText(*scene.hulls);
    request.virtualFiles[kHullFile] = hullText(*scene.hulls);
  }
  if (options.maths == Maths::native) {
    request.aliases["math.glsl"] = "math_native.glsl";
    request.stripPrecise = true;
  }
  return request;
}

}  // namespace twintrace
