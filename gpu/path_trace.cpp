#include "gpu/path_trace.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <span>

#include "gpu/buffers.h"
#include "gpu/context.h"
#include "gpu/passport_cache.h"
#include "gpu/program_cache.h"
#include "gpu/provider.h"
#include "gpu/scene_uniforms.h"
#include "gpu/specialisation.h"

namespace twintrace {
namespace {

constexpr const char* kMainPath = "trace.glsl";
constexpr const char* kMain = R"glsl(
#include "mains/uniforms.glsl"

#include "integrator.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer TraceWords {
  uint traceCount;
  uint traceRadiance[3];
  uint traceWords[];
};
uniform uint firstEvent;
uniform int recordWords;

void main() {
  traceWanted = firstEvent + gl_GlobalInvocationID.x;
  Frame frame = Frame(filmWidth, bounceLimit, passCount, firstSampleIndex, seedValue);
  precise PathState state = beginSample(tileX, tileY, frame.firstSample, frame);
  while (state.alive) {
    state = stepSample(state, frame);
  }
  int to = int(gl_GlobalInvocationID.x) * recordWords;
  TRACE_STORE(to)
  if (gl_GlobalInvocationID.x == 0u) {
    traceCount = traceEvent;
    traceRadiance[0] = floatBitsToUint(state.radiance.x);
    traceRadiance[1] = floatBitsToUint(state.radiance.y);
    traceRadiance[2] = floatBitsToUint(state.radiance.z);
  }
}
)glsl";

constexpr std::size_t kHeaderWords = 4;  // count and radiance
constexpr std::uint32_t kGroupSize = 64;
constexpr std::uint32_t kBatch = 2048;        // events of one dispatch
constexpr std::uint32_t kMostEvents = 60000;  // the work grows with the square of their number

InstrumentedShader tracedShader(Context& context, const FlatScene& scene,
                                const RenderOptions& options, const InstrumentSettings& settings) {
  const ShaderLibrary library = shaderLibrary(options);
  ShaderRequest request = specialise(scene, options, passportOf(context, library).corrections);
  request.main = kMainPath;
  request.virtualFiles[kMainPath] = kMain;
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
    texels_.emplace(*context_, scene_->texels);
    setSceneUniforms(*program_, *scene_, options_);
    program_->set("filmWidth", scene_->width);
    program_->set("bounceLimit", options_.bounces);
    program_->set("seedValue", options_.seed);
    program_->set("passCount", 1);
    recordWords_ = static_cast<std::size_t>(shader_.width) + 1;
    program_->set("recordWords", static_cast<std::int32_t>(recordWords_));
    words_.resize(kHeaderWords + kBatch * recordWords_);
    storage_.emplace(*context_, words_.size() * sizeof(std::uint32_t));
  }

  CallTrace trace(const PixelPosition& pixel, std::uint32_t sample) {
    const Context::Current current = context_->use();
    program_->set("tileX", pixel.x);
    program_->set("tileY", pixel.y);
    program_->set("firstSampleIndex", sample);
    CallTrace trace;
    std::uint32_t count = kBatch;
    for (std::uint32_t first = 0; first < std::min(count, kMostEvents); first += kBatch) {
      run(first, std::min(count - first, kBatch));
      count = words_[0];
      append(trace, std::min(count - first, kBatch));
    }
    trace.lost = count - std::min(count, kMostEvents);
    for (std::size_t i = 0; i < 3; ++i) trace.radiance[i] = std::bit_cast<float>(words_[1 + i]);
    return trace;
  }

  const TraceProgram& program() const { return shader_.program; }

 private:
  void run(std::uint32_t firstEvent, std::uint32_t count) {
    program_->set("firstEvent", firstEvent);
    texels_->bind(0);
    storage_->bind(0);
    program_->dispatch({(count + kGroupSize - 1) / kGroupSize, 1, 1});
    storage_->read(std::as_writable_bytes(std::span(words_)));
  }

  void append(CallTrace& trace, std::uint32_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t* record = &words_[kHeaderWords + i * recordWords_];
      const TraceSite& site = shader_.program.sites.at(record[0]);
      trace.words.insert(trace.words.end(), record, record + 1 + site.slots.size());
    }
  }

  std::shared_ptr<const FlatScene> scene_;
  RenderOptions options_;
  InstrumentedShader shader_;
  std::unique_ptr<Context> context_;
  ProgramCache programs_;
  std::shared_ptr<Program> program_;
  std::optional<BufferTexture> texels_;
  std::optional<StorageBuffer> storage_;
  std::vector<std::uint32_t> words_;
  std::size_t recordWords_ = 0;
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
