#include "gpu/tracer.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "common/base/error.h"
#include "common/base/flush_denormals.h"
#include "common/hulls/hull_structure.h"
#include "gpu/buffers.h"
#include "gpu/context.h"
#include "gpu/passport_cache.h"
#include "gpu/program_cache.h"
#include "gpu/provider.h"
#include "gpu/scene_uniforms.h"
#include "gpu/specialisation.h"
#include "gpu/timer_query.h"

namespace twintrace {
namespace {

constexpr int kGroupSize = 8;  // local_size of mains/compute.glsl

// Larger films are drawn in tiles of about equal size, so that no limit of the device on textures,
// buffers or work groups limits the film. 2048 x 2048 is far below all of them.
constexpr int kMaxTileSide = 2048;

int tileSide(int length) {
  const int tiles = (length + kMaxTileSide - 1) / kMaxTileSide;
  return (length + tiles - 1) / tiles;
}

class GpuRenderer : public Renderer {
 public:
  GpuRenderer(std::shared_ptr<const FlatScene> scene, const RenderOptions& options)
      : scene_(std::move(scene)),
        options_(options),
        tileWidth_(tileSide(scene_->width)),
        tileHeight_(tileSide(scene_->height)),
        context_(createContext(options.provider, options.threads)),
        programs_(*context_),
        timer_(*context_) {
    const Context::Current current = context_->use();
    const ShaderLibrary library = shaderLibrary(options);
    passport_ = passportOf(*context_, library);
    const ShaderSource source =
        assembleShader(library, specialise(*scene_, options, passport_.corrections));
    unusedOverrides_ = unusedOverrides(source);
    program_ = programs_.get(options.stage, source);
    textures_.emplace(*context_, *scene_);
    if (options.stage == Stage::fragment) {
      target_.emplace(*context_, tileWidth_, tileHeight_);
    } else {
      storage_.emplace(*context_, tilePixels() * channels() * sizeof(float));
    }
    pixels_.resize(tilePixels() * channels());
    setFixedUniforms();
  }

  double renderFrame(std::uint32_t firstSample, int passes, std::span<float> sums) override {
    assert(sums.size() == std::size_t{3} * scene_->width * scene_->height);
    const Context::Current current = context_->use();
    double seconds = 0;
    if (!passByPass_) {
      seconds += renderPasses(firstSample, passes, sums);
      if (!loopsCut_) return seconds;
      passByPass_ = true;
    }
    return seconds + renderPassByPass(firstSample, passes, sums);
  }

  Provenance provenance() const override {
    Provenance facts = {{"backend", "gpu"},
                        {"gl_renderer", context_->renderer()},
                        {"gl_version", context_->version()},
                        {"gl_source", context_->source()},
                        {"geometry", usesLiteralGeometry(*scene_, options_) ? "literal" : "buffer"},
                        {"hull", hullName(*scene_)},
                        {"program", programs_.counts().compiled > 0 ? "compiled" : "cached"}};
    if (passByPass_) facts.emplace_back("passes_apart", "the device ends long loops");
    if (!unusedOverrides_.empty()) facts.emplace_back("unused_overrides", unusedOverrides_);
    addPassport(facts);
    if (deviceSeconds_ > 0) facts.emplace_back("device_seconds", std::to_string(deviceSeconds_));
    return facts;
  }

 private:
  /// All passes of a frame in one draw for each tile. Sets loopsCut_ if the device ended a loop early.
  double renderPasses(std::uint32_t firstSample, int passes, std::span<float> sums) {
    loopsCut_ = false;
    program_->set("firstSampleIndex", firstSample);
    program_->set("passCount", passes);
    textures_->bind();
    double seconds = 0;
    for (int y = 0; y < scene_->height; y += tileHeight_) {
      for (int x = 0; x < scene_->width; x += tileWidth_) {
        seconds += renderTile(x, y);
        copyTile(x, y, sums);
      }
    }
    return seconds;
  }

  /// The same sums, pass by pass: few enough rounds of loops for devices that limit them.
  double renderPassByPass(std::uint32_t firstSample, int passes, std::span<float> sums) {
    std::vector<float> pass(sums.size());
    double seconds = 0;
    for (int i = 0; i < passes; ++i) {
      seconds += renderPasses(firstSample + static_cast<std::uint32_t>(i), 1, i == 0 ? sums : pass);
      if (loopsCut_) {
        throw DeviceError(context_->renderer() +
                          " ends loops before their time: too many primitives or bounces for it; "
                          "expected a hull strategy, or fewer bounces");
      }
      const FlushDenormals flush;  // as the shaders add
      for (std::size_t k = 0; i > 0 && k < sums.size(); ++k) sums[k] += pass[k];
    }
    return seconds;
  }

  /// Shaders whose replacement the program doesn't include, as in "math.glsl, path.glsl".
  std::string unusedOverrides(const ShaderSource& source) const {
    std::string unused;
    for (const ShaderReplacement& replacement : options_.shaderOverrides) {
      const bool used = std::ranges::find(source.files, replacement.file) != source.files.end();
      if (!used) unused += (unused.empty() ? "" : ", ") + replacement.shader;
    }
    return unused;
  }

  void addPassport(Provenance& facts) const {
    facts.emplace_back("passport", passport_.digest());
    facts.emplace_back("strict", passport_.strictness());
    if (options_.maths != Maths::strict) return;
    const Corrections& corrections = passport_.corrections;
    facts.emplace_back("division", corrections.division ? "corrected" : "device");
    facts.emplace_back("square_root", corrections.root ? "corrected" : "device");
  }

  std::size_t tilePixels() const {
    return static_cast<std::size_t>(tileWidth_) * static_cast<std::size_t>(tileHeight_);
  }

  /// Floats per pixel that both stages write: the sum, and 1 if all loops ran to their ends.
  static constexpr std::size_t channels() { return 4; }

  /// @return seconds of wall time until the device is done.
  double renderTile(int x, int y) {
    program_->set("tileX", x);
    program_->set("tileY", y);
    timer_.start();
    if (target_) {
      target_->draw(*program_);
    } else {
      storage_->bind(0);
      program_->dispatch({(tileWidth_ + kGroupSize - 1) / kGroupSize,
                          (tileHeight_ + kGroupSize - 1) / kGroupSize, 1});
    }
    timer_.stop();
    if (const auto seconds = timer_.deviceSeconds()) deviceSeconds_ += *seconds;
    return timer_.wallSeconds();
  }

  /// Copies the part of a tile that lies on the film.
  void copyTile(int x0, int y0, std::span<float> sums) {
    if (target_) {
      target_->read(pixels_);
    } else {
      storage_->read(std::as_writable_bytes(std::span(pixels_)));
    }
    const int columns = std::min(tileWidth_, scene_->width - x0);
    const int rows = std::min(tileHeight_, scene_->height - y0);
    for (int y = 0; y < rows; ++y) {
      const float* from = &pixels_[static_cast<std::size_t>(y) * tileWidth_ * channels()];
      float* to = &sums[3 * (static_cast<std::size_t>(y0 + y) * scene_->width + x0)];
      for (int x = 0; x < columns; ++x, from += channels(), to += 3) {
        std::copy_n(from, 3, to);
        loopsCut_ = loopsCut_ || from[3] != 1.0f;
      }
    }
  }

  void setFixedUniforms() {
    setSceneUniforms(*program_, *scene_, options_);
    program_->set("filmWidth", scene_->width);
    program_->set("tileWidth", tileWidth_);
    program_->set("tileHeight", tileHeight_);
    program_->set("bounceLimit", options_.bounces);
    program_->set("seedValue", options_.seed);
    program_->set("loopRounds", 2);
  }

  std::shared_ptr<const FlatScene> scene_;
  RenderOptions options_;
  int tileWidth_;
  int tileHeight_;
  std::unique_ptr<Context> context_;
  ProgramCache programs_;
  std::shared_ptr<Program> program_;
  std::optional<SceneTextures> textures_;
  std::optional<FloatTarget> target_;
  std::optional<StorageBuffer> storage_;
  TimerQuery timer_;
  DevicePassport passport_;
  std::vector<float> pixels_;
  std::string unusedOverrides_;
  double deviceSeconds_ = 0;
  bool loopsCut_ = false;    ///< by the device, in the last draws
  bool passByPass_ = false;  ///< since it did so once
};

}  // namespace

std::unique_ptr<Renderer> makeGpuRenderer(std::shared_ptr<const FlatScene> scene,
                                          const RenderOptions& options) {
  refuseCpuOptions(options);
  return std::make_unique<GpuRenderer>(std::move(scene), options);
}

}  // namespace twintrace
