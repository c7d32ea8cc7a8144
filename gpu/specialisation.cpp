#include "gpu/specialisation.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/base/error.h"
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

std::string effectConstants(const EffectSet& effects) {
  std::string text;
  for (int i = 0; i < kEffectCount; ++i) {
    std::string name(kEffectNames[i]);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    text += boolConstant("kEffect" + name, effects.has(static_cast<Effect>(i)));
  }
  return text;
}

std::string indexText(const FlatScene& scene, bool uniforms) {
  std::string text;
  for (const auto& [name, value] : indexConstants(scene.index)) {
    text += uniforms ? fmt::format("uniform int {};\n", name)
                     : constant("int", name, std::to_string(value));
  }
  return text;
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

bool overridesGeometry(const RenderOptions& options) {
  return std::ranges::find(options.shaderOverrides, kGeometryFile, &ShaderReplacement::shader) !=
         options.shaderOverrides.end();
}

}  // namespace

bool usesLiteralGeometry(const FlatScene& scene, const RenderOptions& options) {
  const int count = scene.index.primitiveCount();
  if (options.geometry == Geometry::buffer) return false;
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

std::vector<std::pair<std::string, int>> indexConstants(const SceneIndex& index) {
  return {{"kSphereCount", index.sphereCount},
          {"kBoxCount", index.boxCount},
          {"kOrientedBoxCount", index.orientedBoxCount},
          {"kPlaneCount", index.planeCount},
          {"kLightCount", index.lightCount},
          {"kSphereOffset", index.sphereOffset},
          {"kBoxOffset", index.boxOffset},
          {"kOrientedBoxOffset", index.orientedBoxOffset},
          {"kPlaneOffset", index.planeOffset},
          {"kInfoOffset", index.infoOffset},
          {"kMaterialOffset", index.materialOffset},
          {"kLightOffset", index.lightOffset},
          {"kEnvironmentOffset", index.environmentOffset},
          {"kEnvironmentWidth", index.environmentWidth},
          {"kEnvironmentHeight", index.environmentHeight}};
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
                         const Corrections& corrections) {
  ShaderRequest request;
  request.main =
      options.stage == Stage::fragment ? "mains/fragment.glsl" : "mains/compute.glsl";
  request.prelude =
      correctionConstants(corrections) + effectConstants(scene.effects) +
      boolConstant("kNoiseSine", options.noise == Noise::sine) +
      boolConstant("kIntersectorReport", options.intersector == Intersector::report) +
      constant("int", "kIntegrator", std::to_string(static_cast<int>(options.integrator))) +
      indexText(scene, usesUniformIndex(scene, options));
  if (usesLiteralGeometry(scene, options)) {
    request.virtualFiles[kGeometryFile] = LiteralGeometry(scene).text();
  }
  if (options.maths == Maths::native) {
    request.aliases["math.glsl"] = "math_native.glsl";
    request.stripPrecise = true;
  }
  return request;
}

}  // namespace twintrace
