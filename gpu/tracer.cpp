#include "gpu/tracer.h"

#include <optional>

#include "common/base/error.h"
#include "gpu/buffers.h"
#include "gpu/context.h"
#include "gpu/program_cache.h"
#include "gpu/provider.h"
#include "gpu/scene_uniforms.h"
#include "gpu/specialisation.h"
#include "gpu/timer_query.h"

namespace twintrace {
namespace {

constexpr int kGroupSize = 8;  // local_size of mains/compute.glsl

void refuseCpuOptions(const RenderOptions& options) {
  if (options.precision == Precision::float64) {
    throw UsageError("precision double with backend gpu, expected backend cpu: shaders compute in "
                     "float");
  }
  if (options.hull == "embree") {
    throw UsageError("hull embree with backend gpu, expected backend cpu: Embree runs there only");
  }
}

class GpuRenderer : public Renderer {
 public:
  GpuRenderer(std::shared_ptr<const FlatScene> scene, const RenderOptions& options)
      : scene_(std::move(scene)),
        options_(options),
        context_(createContext(options.provider, options.threads)),
        programs_(*context_),
        timer_(*context_) {
    const Context::Current current = context_->use();
    const ShaderLibrary library(options.shaderDirectory);
    program_ = programs_.get(options.stage, assembleShader(library, specialise(*scene_, options)));
    texels_.emplace(*context_, scene_->texels);
    if (options.stage == Stage::fragment) {
      target_.emplace(*context_, scene_->width, scene_->height);
      pixels_.resize(pixelCount() * 4);
    } else {
      storage_.emplace(*context_, pixelCount() * 3 * sizeof(float));
    }
    setFixedUniforms();
  }

  double renderFrame(std::uint32_t firstSample, int passes, std::span<float> sums) override {
    const Context::Current current = context_->use();
    program_->set("firstSampleIndex", firstSample);
    program_->set("passCount", passes);
    texels_->bind(0);
    timer_.start();
    if (target_) {
      target_->draw(*program_);
    } else {
      storage_->bind(0);
      program_->dispatch({(scene_->width + kGroupSize - 1) / kGroupSize,
                          (scene_->height + kGroupSize - 1) / kGroupSize, 1});
    }
    timer_.stop();
    if (const auto seconds = timer_.deviceSeconds()) deviceSeconds_ += *seconds;
    readSums(sums);
    return timer_.wallSeconds();
  }

  Provenance provenance() const override {
    Provenance facts = {{"backend", "gpu"},
                        {"gl_renderer", context_->renderer()},
                        {"gl_version", context_->version()},
                        {"gl_source", context_->source()},
                        {"geometry", usesLiteralGeometry(*scene_, options_) ? "literal" : "buffer"},
                        {"program", programs_.counts().compiled > 0 ? "compiled" : "cached"}};
    if (deviceSeconds_ > 0) facts.emplace_back("device_seconds", std::to_string(deviceSeconds_));
    return facts;
  }

 private:
  std::size_t pixelCount() const {
    return static_cast<std::size_t>(scene_->width) * static_cast<std::size_t>(scene_->height);
  }

  void setFixedUniforms() {
    setSceneUniforms(*program_, *scene_, options_);
    program_->set("filmWidth", scene_->width);
    program_->set("filmHeight", scene_->height);
    program_->set("bounceLimit", options_.bounces);
    program_->set("seedValue", options_.seed);
  }

  void readSums(std::span<float> sums) {
    if (storage_) {
      storage_->read(std::as_writable_bytes(sums));
      return;
    }
    target_->read(pixels_);
    for (std::size_t i = 0; i < pixelCount(); ++i) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        sums[3 * i + channel] = pixels_[4 * i + channel];
      }
    }
  }

  std::shared_ptr<const FlatScene> scene_;
  RenderOptions options_;
  std::unique_ptr<Context> context_;
  ProgramCache programs_;
  std::shared_ptr<Program> program_;
  std::optional<BufferTexture> texels_;
  std::optional<FloatTarget> target_;
  std::optional<StorageBuffer> storage_;
  TimerQuery timer_;
  std::vector<float> pixels_;
  double deviceSeconds_ = 0;
};

}  // namespace

std::unique_ptr<Renderer> makeGpuRenderer(std::shared_ptr<const FlatScene> scene,
                                          const RenderOptions& options) {
  refuseCpuOptions(options);
  return std::make_unique<GpuRenderer>(std::move(scene), options);
}

}  // namespace twintrace
