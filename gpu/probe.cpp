#include "gpu/probe.h"

#include "common/base/error.h"
#include "gpu/buffers.h"
#include "gpu/context.h"
#include "gpu/passport_cache.h"
#include "gpu/program.h"
#include "gpu/scene_uniforms.h"
#include "gpu/specialisation.h"

namespace twintrace {
namespace {

constexpr const char* kMainPath = "probe.glsl";

ShaderRequest probeRequest(const Probe& probe, const FlatScene& scene,
                           const RenderOptions& options, const Corrections& corrections) {
  ShaderRequest request = specialise(scene, options, corrections);
  request.main = kMainPath;
  request.virtualFiles[kMainPath] = probe.main;
  return request;
}

}  // namespace

std::vector<std::uint32_t> runProbe(Context& context, const ShaderLibrary& library,
                                    const Probe& probe, const FlatScene& scene,
                                    const RenderOptions& options,
                                    std::span<const std::uint32_t> inputs) {
  const auto inputWords = static_cast<std::size_t>(probe.inputWords);
  if (inputs.empty() || inputWords == 0 || inputs.size() % inputWords != 0) {
    throw UsageError(std::to_string(inputs.size()) + " words of probe inputs, expected a multiple of " +
                     std::to_string(inputWords));
  }
  const std::size_t count = inputs.size() / inputWords;
  const Context::Current current = context.use();
  const Corrections corrections = passportOf(context, library).corrections;
  Program program(context, Stage::compute,
                  assembleShader(library, probeRequest(probe, scene, options, corrections)));
  const BufferTexture texels(context, scene.texels);
  const StorageBuffer given(context, std::as_bytes(inputs));
  std::vector<std::uint32_t> results(count * static_cast<std::size_t>(probe.outputWords));
  const StorageBuffer found(context, results.size() * sizeof(std::uint32_t));
  texels.bind(0);
  given.bind(0);
  found.bind(1);
  setSceneUniforms(program, scene, options);
  program.set("probeCount", static_cast<std::int32_t>(count));
  const auto groups = static_cast<std::uint32_t>((count + kProbeGroupSize - 1) / kProbeGroupSize);
  program.dispatch({groups, 1, 1});
  found.read(std::as_writable_bytes(std::span(results)));
  return results;
}

}  // namespace twintrace
