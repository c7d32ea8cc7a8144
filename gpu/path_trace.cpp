#include "gpu/path_trace.h"

#include <optional>
#include <stdexcept>
#include <span>

#include "gpu/buffers.h"
#include "gpu/context.h"
#include "gpu/passport_cache.h"
#include "gpu/program_cache.h"
#include "gpu/provider.h"
#include "gpu/scene_uniforms.h"
#include "gpu/specialisation.h"
#include "gpu/trace_records.h"

namespace twintrace {
namespace {

constexpr const char* kMainPath = "trace.glsl";
constexpr const char* kMain = R"glsl(
#include "mains/uniforms.glsl"

#include "integrator.glsl"

#include "trace_records.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer TraceRadiance {
  uint traceRadiance[3];
};

void main() {
  traceChoose();
  Frame frame = Frame(filmWidth, bounceLimit, passCount, firstSampleIndex, seedValue);
  precise PathState state = beginSample(tileX, tileY, frame.firstSample, frame);
  while (state.alive) {
    state = stepSample(state, frame);
  }
  traceKeep();
  if (gl_GlobalInvocationID.x == 0u) {
    traceRadiance[0] = floatBitsToUint(state.radiance.x);
    traceRadiance[1] = floatBitsToUint(state.radiance.y);
    traceRadiance[2] = floatBitsToUint(state.radiance.z);
  }
}
)glsl";

/// Walks through hulls are no part of a trace: the C++ tracer's are not, and what they find is the result
/// of closestHit, which calls this one function.
void muteWalk(ShaderRequest& request, InstrumentSettings& settings) {
  const auto given = settings.calls;
  settings.calls = [given](const GlslFunction& function) {
    return function.name != kWalkFunction && (!given || given(function));
  };
  const auto walk = request.virtualFiles.find(kWalkFile);
  if (walk == request.virtualFiles.end()) return;
  const auto put = [&](std::string_view before, std::string_view statement) {
    const std::size_t at = walk->second.find(before);
    if (at == std::string::npos) throw std::logic_error("a walk without " + std::string(before));
    walk->second.insert(at, statement);
  };
  put("precise Hit planes", "traceMuted = true;\n  ");
  put("return result;", "traceMuted = false;\n  ");
}

InstrumentedShader tracedShader(Context& context, const FlatScene& scene,
                                const RenderOptions& options, InstrumentSettings settings) {
  const ShaderLibrary library = shaderLibrary(options);
  ShaderRequest request = specialise(scene, options, passportOf(context, library).corrections);
  request.main = kMainPath;
  request.virtualFiles[kMainPath] = kMain;
  request.virtualFiles[kTraceRecordsPath] = traceRecordsText();
  muteWalk(request, settings);
  return instrumentShader(assembleShader(library, request), settings);
}

/// Geometry as literals has no functions that could be compared with the twin's.
RenderOptions withBuffers(RenderOptions options) {
  options.geometry = Geometry::buffer;
  options.stage = Stage::compute;
  return options;
}

}  // namespace

class GpuPathTracer::Device {
 public:
  Device(std::shared_ptr<const FlatScene> scene, const RenderOptions& options,
         const InstrumentSettings& settings)
      : scene_(std::move(scene)),
        options_(withBuffers(options)),
        context_(createContext(options.provider, options.threads)),
        programs_(*context_) {
    const Context::Current current = context_->use();
    shader_ = tracedShader(*context_, *scene_, options_, settings);
    program_ = programs_.get(Stage::compute, shader_.source);
    textures_.emplace(*context_, *scene_);
    setSceneUniforms(*program_, *scene_, options_);
    program_->set("filmWidth", scene_->width);
    program_->set("bounceLimit", options_.bounces);
    program_->set("seedValue", options_.seed);
    program_->set("passCount", 1);
    radiance_.emplace(*context_, 3 * sizeof(std::uint32_t));
    records_.emplace(*context_, *program_, shader_);
  }

  CallTrace trace(const PixelPosition& pixel, std::uint32_t sample) {
    const Context::Current current = context_->use();
    program_->set("tileX", pixel.x);
    program_->set("tileY", pixel.y);
    program_->set("firstSampleIndex", sample);
    textures_->bind();
    radiance_->bind(0);
    CallTrace trace = records_->collect();
    radiance_->read(std::as_writable_bytes(std::span(trace.radiance)));
    return trace;
  }

  const TraceProgram& program() const { return shader_.program; }

 private:
  std::shared_ptr<const FlatScene> scene_;
  RenderOptions options_;
  InstrumentedShader shader_;
  std::unique_ptr<Context> context_;
  ProgramCache programs_;
  std::shared_ptr<Program> program_;
  std::optional<SceneTextures> textures_;
  std::optional<StorageBuffer> radiance_;
  std::optional<TraceRecords> records_;
};

GpuPathTracer::GpuPathTracer(std::shared_ptr<const FlatScene> scene, const RenderOptions& options,
                             const InstrumentSettings& settings)
    : device_(std::make_unique<Device>(std::move(scene), options, settings)) {}

GpuPathTracer::~GpuPathTracer() = default;

CallTrace GpuPathTracer::trace(const PixelPosition& pixel, std::uint32_t sample) {
  return device_->trace(pixel, sample);
}

const TraceProgram& GpuPathTracer::program() const {
  return device_->program();
}

}  // namespace twintrace
