#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "common/scene/flat_scene.h"
#include "common/scene/reader.h"
#include "experiments/explain/explanation.h"
#include "gpu/shader_source.h"

namespace twintrace::test {

/// A ball with two lobes on a plane, and a lamp: drivers take seconds to compile the instrumented
/// program of a shipped scene.
inline const std::string kBallScene =
    TWINTRACE_SOURCE_DIR "/tests/unit/experiments/explain/ball.toml";

/// A shipped scene, or one given by its whole path, on a small film.
struct SmallScene {
  explicit SmallScene(const std::string& name)
      : scene(readScene(std::filesystem::path(TWINTRACE_SOURCE_DIR "/experiments/scenes") / name)) {
    options = scene.render;
    options.width = 16;
    options.height = 16;
    flat = std::make_shared<const FlatScene>(flatten(scene, options));
  }

  std::unique_ptr<PathTracer> cpu(TraceDetail detail = TraceDetail::statements) const {
    return makePathTracer(flat, options, detail);
  }

  /// The GLSL tracer, with changed shaders.
  std::unique_ptr<PathTracer> gpu(const std::vector<ShaderReplacement>& changed = {},
                                  TraceDetail detail = TraceDetail::statements) const {
    RenderOptions own = options;
    own.backend = BackEnd::gpu;
    own.shaderOverrides = changed;
    return makePathTracer(flat, own, detail);
  }

  Scene scene;
  RenderOptions options;
  std::shared_ptr<const FlatScene> flat;
};

/// A shader of the library with one text in the place of another.
inline ShaderReplacement changedShader(const std::string& name, const std::string& from,
                                       const std::string& to) {
  std::string text = ShaderLibrary().find(name).value().text;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument(name + " lacks " + from);
  return {name, "changed/" + name, text.replace(at, from.size(), to)};
}

/// The first sample, going over the film, whose radiance differs; nothing if there is none.
/// It refers to the tracers, which have to outlive it.
inline std::unique_ptr<SampleExplanation> firstDifferent(PathTracer& a, PathTracer& b,
                                                         std::uint32_t samples = 2) {
  for (std::uint32_t sample = 0; sample < samples; ++sample) {
    for (int at = 0; at < 256; ++at) {
      auto result = std::make_unique<SampleExplanation>();
      explainSample(a, b, {at % 16, at / 16}, sample, *result);
      if (!result->sameRadiance) return result;
    }
  }
  return nullptr;
}

/// The function to which a difference is traced.
inline std::string culprit(const SampleExplanation& explanation) {
  if (!explanation.divergence) return "none";
  return std::string(explanation.treeA.name(explanation.divergence->a));
}

}  // namespace twintrace::test
