#include "gpu/probe.h"

#include "common/base/error.h"
#include "gpu/buffers.h"
#include "gpu/context.h"
#include "gpu/passport_cache.h"
#include "gpu/program.h"
#include "gpu/scene_uniforms.h"
#include "gpu/specialisation.h"
#include "gpu/trace_records.h"

namespace twintrace {
namespace {

constexpr const char* kMainPath = "probe.glsl";
constexpr const char* kTracedMainPath = "traced_probe.glsl";

// Calls the probe's own main, renamed, and stores the events of the call.
constexpr const char* kTracedMain = R"glsl(
#define main probeMain
#include "probe.glsl"
#undef main
#include "trace_records.glsl"

void main() {
  traceChoose();
  probeMain();
  traceKeep();
}
)glsl";

static_assert(kTraceGroupSize == kProbeGroupSize);

ShaderRequest probeRequest(const Probe& probe, const FlatScene& scene, const RenderOptions& options,
                           const Corrections& corrections) {
  ShaderRequest request = specialise(scene, options, corrections);
  request.virtualFiles.erase(kWalkFile);  // hulls are probed alone: queries test every primitive
  request.main = kMainPath;
  request.virtualFiles[kMainPath] = probe.main;
  return request;
}

std::size_t recordCount(const Probe& probe, std::span<const std::uint32_t> inputs) {
  const auto inputWords = static_cast<std::size_t>(probe.inputWords);
  if (inputs.empty() || inputWords == 0 || inputs.size() % inputWords != 0) {
    throw UsageError(std::to_string(inputs.size()) +
                     " words of probe inputs, expected a multiple of " +
                     std::to_string(inputWords));
  }
  return inputs.size() / inputWords;
}

/// A probe's program with its buffers.
class ProbeProgram {
 public:
  ProbeProgram(Context& context, const ShaderSource& source, const Probe& probe,
               const FlatScene& scene, const RenderOptions& options,
               std::span<const std::uint32_t> inputs)
      : program_(context, Stage::compute, source),
        textures_(context, scene),
        given_(context, std::as_bytes(inputs)),
        outputs_(recordCount(probe, inputs) * static_cast<std::size_t>(probe.outputWords)),
        found_(context, outputs_.size() * sizeof(std::uint32_t)) {
    setSceneUniforms(program_, scene, options);
    program_.set("probeCount", static_cast<std::int32_t>(recordCount(probe, inputs)));
    textures_.bind();
    given_.bind(0);
    found_.bind(1);
  }

  Program& program() { return program_; }

  const std::vector<std::uint32_t>& outputs() {
    found_.read(std::as_writable_bytes(std::span(outputs_)));
    return outputs_;
  }

 private:
  Program program_;
  SceneTextures textures_;
  StorageBuffer given_;
  std::vector<std::uint32_t> outputs_;
  StorageBuffer found_;
};

}  // namespace

std::vector<std::uint32_t> runProbe(Context& context, const ShaderLibrary& library,
                                    const Probe& probe, const FlatScene& scene,
                                    const RenderOptions& options,
                                    std::span<const std::uint32_t> inputs) {
  const std::size_t count = recordCount(probe, inputs);
  const Context::Current current = context.use();
  const Corrections corrections = passportOf(context, library).corrections;
  const ShaderRequest request = probeRequest(probe, scene, options, corrections);
  ProbeProgram run(context, assembleShader(library, request), probe, scene, options, inputs);
  const auto groups = static_cast<std::uint32_t>((count + kProbeGroupSize - 1) / kProbeGroupSize);
  run.program().dispatch({groups, 1, 1});
  return run.outputs();
}

ProbeTrace traceProbe(Context& context, const ShaderLibrary& library, const Probe& probe,
                      const FlatScene& scene, const RenderOptions& options,
                      std::span<const std::uint32_t> inputs, const InstrumentSettings& settings) {
  const Context::Current current = context.use();
  ShaderRequest request =
      probeRequest(probe, scene, options, passportOf(context, library).corrections);
  request.main = kTracedMainPath;
  request.virtualFiles[kTracedMainPath] = kTracedMain;
  request.virtualFiles[kTraceRecordsPath] = traceRecordsText();
  const InstrumentedShader shader = instrumentShader(assembleShader(library, request), settings);
  std::vector<std::uint32_t> copies;  // one for each invocation, since each keeps another event
  for (std::uint32_t i = 0; i < kTraceBatch; ++i) {
    copies.insert(copies.end(), inputs.begin(), inputs.end());
  }
  ProbeProgram run(context, shader.source, probe, scene, options, copies);
  ProbeTrace result{shader.program, TraceRecords(context, run.program(), shader).collect(),
                    run.outputs()};
  result.outputs.resize(static_cast<std::size_t>(probe.outputWords));
  return result;
}

}  // namespace twintrace
