#include "experiments/arm.h"

#include <fmt/format.h>

#include <array>
#include <map>

#include "common/base/error.h"
#include "common/scene/option_names.h"
#include "cpu/tracer.h"
#include "experiments/build_info.h"
#include "experiments/effect_ledger.h"
#include "experiments/machine.h"
#include "experiments/shader_hash.h"
#include "gpu/tracer.h"

namespace twintrace {
namespace {

/// Options of which every value may change the samples.
constexpr std::array kBitOptions = {"integrator",  "noise",   "maths", "precision",
                                    "intersector", "bounces", "seed"};

/// As in `intersect.glsl=HASH,math.glsl=HASH`; the files' own names change no bit.
std::string overrideHashes(const RenderOptions& options) {
  std::map<std::string, std::string> hashes;
  for (const ShaderReplacement& replacement : options.shaderOverrides) {
    hashes[replacement.shader] = shaderTextHash(replacement.text);
  }
  std::string text;
  for (const auto& [shader, hash] : hashes) {
    text += (text.empty() ? "" : ",") + shader + "=" + hash;
  }
  return text;
}

EffectSet both(const EffectSet& a, const EffectSet& b) {
  EffectSet common;
  for (int i = 0; i < kEffectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    common.set(effect, a.has(effect) && b.has(effect));
  }
  return common;
}

void addOption(FilmMetadata& metadata, const RenderOptions& options, const char* name) {
  metadata[name] = findOption(name)->get(options);
}

/// What the GPU does not have must not be ignored: the result would bear the wrong name.
void checkGpuOptions(const RenderOptions& options) {
  if (options.precision == Precision::float64) {
    throw UsageError(
        "found precision double with backend gpu, expected backend cpu or precision "
        "float");
  }
  if (options.hull == "bvh8") {
    throw UsageError("found hull bvh8 with backend gpu, expected backend cpu or hull bvh");
  }
  if (options.hull == "embree") {
    throw UsageError(
        "found hull embree with backend gpu, expected backend cpu or hull auto or none");
  }
}

std::unique_ptr<Renderer> openRenderer(std::shared_ptr<const FlatScene> scene,
                                       const RenderOptions& options) {
  if (options.backend == BackEnd::cpu) return makeCpuRenderer(std::move(scene), options);
  checkGpuOptions(options);
  return makeGpuRenderer(std::move(scene), options);
}

/// Native maths of shaders is whatever the driver makes of it.
void addDriver(Arm& arm) {
  if (arm.options.maths != Maths::native || arm.options.backend != BackEnd::gpu) return;
  addOption(arm.metadata, arm.options, "gl");
  for (const auto& [name, value] : arm.renderer->provenance()) {
    if (name == "gl_renderer" || name == "gl_version") arm.metadata[name] = value;
  }
}

}  // namespace

std::shared_ptr<const FlatScene> flattenScene(const Scene& scene, const RenderOptions& options) {
  checkOptions(options);
  try {
    return std::make_shared<const FlatScene>(flatten(scene, options));
  } catch (const IoError& error) {
    // What a scene names is part of the scene: not a main input that can't be read.
    throw FileError({Diagnostic{SourceLocation{scene.path}, error.what()}});
  }
}

FilmMetadata filmMetadata(const Scene& scene, const FlatScene& flat, const RenderOptions& options) {
  const auto names = effectNames(both(flat.effects, neededEffects(scene, options)));
  FilmMetadata metadata = {{"version", buildInfo().version},
                           {"scene", scene.name},
                           {"scene_hash", sceneHash(flat)},
                           {"effects", fmt::format("{}", fmt::join(names, ","))}};
  for (const char* name : kBitOptions) addOption(metadata, options, name);
  if (options.maths == Maths::native) {
    addOption(metadata, options, "backend");
    if (options.backend == BackEnd::gpu) {
      addOption(metadata, options, "stage");
      addOption(metadata, options, "geometry");
    }
  }
  if (options.backend == BackEnd::gpu && !options.shaderDirectory.empty()) {
    metadata["shader_hash"] = shaderDirectoryHash(options.shaderDirectory);
  }
  if (options.backend == BackEnd::gpu && !options.shaderOverrides.empty()) {
    metadata["shader_overrides"] = overrideHashes(options);
  }
  return metadata;
}

Arm openArm(const Scene& scene, const RenderOptions& options) {
  checkOptions(options);
  checkFilmMemory(options.width, options.height, availableMemory());
  Arm arm;
  arm.options = options;
  arm.scene = flattenScene(scene, options);
  arm.metadata = filmMetadata(scene, *arm.scene, options);
  arm.renderer = openRenderer(arm.scene, options);
  addDriver(arm);
  return arm;
}

}  // namespace twintrace
