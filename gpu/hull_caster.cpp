#include "gpu/hull_caster.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <optional>

#include "common/base/error.h"
#include "gpu/context.h"
#include "gpu/passport_cache.h"
#include "gpu/program_cache.h"
#include "gpu/provider.h"
#include "gpu/scene_uniforms.h"
#include "gpu/specialisation.h"
#include "gpu/timer_query.h"

namespace twintrace {
namespace {

constexpr std::uint32_t kGroupSize = 64;  // local_size of mains/query.glsl
constexpr std::size_t kChunk = 1u << 20;  // rays per run: 32 MiB of ray texels
constexpr int kTargetWidth = 1024;        // of the fragment stage's picture: a pixel per ray
constexpr std::uint32_t kRayUnit = 1;     // texture unit
constexpr int kAttachments = 3;
// Primitives come back as floats, which the fragment stage has for outputs.
constexpr int kMostPrimitives = 1 << 24;

std::uint32_t word(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

std::vector<glm::uvec4> rayTexels(std::span<const CastRay> rays) {
  std::vector<glm::uvec4> texels;
  texels.reserve(2 * rays.size());
  for (const CastRay& ray : rays) {
    const glm::vec3& o = ray.origin;
    const glm::vec3& d = ray.direction;
    texels.emplace_back(word(o.x), word(o.y), word(o.z), word(ray.tmin));
    texels.emplace_back(word(d.x), word(d.y), word(d.z), word(ray.tmax));
  }
  return texels;
}

/// A ray's answer in the order of the mains: t, primitive and seven counters.
constexpr std::size_t kAnswerFloats = 9;
using Answer = std::array<float, kAnswerFloats>;

/// @throws DeviceError for a ray whose loops the device ended.
void requireWhole(const Context& context, const Answer& answer) {
  if (answer[0] == answer[0]) return;
  throw DeviceError(context.renderer() +
                    " ends loops before their time: too many primitives without hulls");
}

HullHit hitOf(const Answer& answer) {
  const bool missed = answer[1] >= static_cast<float>(kMostPrimitives);
  return {answer[0], missed ? layout::kNoPrimitive : static_cast<std::int32_t>(answer[1])};
}

HullCounts countsOf(const Answer& answer) {
  const auto count = [&](std::size_t i) { return static_cast<std::int32_t>(answer[i]); };
  return {count(2), count(3), count(4), count(5), count(6), count(7), count(8)};
}

class GpuHullCaster : public HullCaster {
 public:
  GpuHullCaster(std::shared_ptr<const FlatScene> scene, const RenderOptions& options)
      : scene_(std::move(scene)),
        options_(options),
        context_(createContext(options.provider, options.threads)),
        programs_(*context_),
        timer_(*context_) {
    const Context::Current current = context_->use();
    textures_.emplace(*context_, *scene_);
    program_ = makeProgram(false);
  }

  double cast(std::span<const CastRay> rays, std::span<HullHit> hits) override {
    assert(hits.size() == rays.size());
    const Context::Current current = context_->use();
    return run(*program_, rays, false,
               [&](std::size_t i, const Answer& answer) { hits[i] = hitOf(answer); });
  }

  std::vector<HullCounts> count(std::span<const CastRay> rays) override {
    const Context::Current current = context_->use();
    if (counting_ == nullptr) counting_ = makeProgram(true);
    std::vector<HullCounts> counts(rays.size());
    run(*counting_, rays, true,
        [&](std::size_t i, const Answer& answer) { counts[i] = countsOf(answer); });
    if (scene_->hulls != nullptr) return counts;
    for (HullCounts& each : counts) each.primitiveTests = scene_->index.boundedCount();
    return counts;
  }

 private:
  std::shared_ptr<Program> makeProgram(bool counting) {
    const ShaderLibrary library = shaderLibrary(options_);
    ShaderRequest request =
        specialise(*scene_, options_, passportOf(*context_, library).corrections, counting);
    request.main =
        options_.stage == Stage::fragment ? "mains/query_fragment.glsl" : "mains/query.glsl";
    return programs_.get(options_.stage, assembleShader(library, request));
  }

  template <class Take>
  double run(Program& program, std::span<const CastRay> rays, bool counting, const Take& take) {
    setSceneUniforms(program, *scene_, options_);
    program.set("rayTexels", static_cast<std::int32_t>(kRayUnit));
    program.set("loopRounds", 2);
    textures_->bind();
    double seconds = 0.0;
    for (std::size_t first = 0; first < rays.size(); first += kChunk) {
      const std::size_t count = std::min(kChunk, rays.size() - first);
      const BufferTexture texels(*context_, rayTexels(rays.subspan(first, count)));
      texels.bind(kRayUnit);
      program.set("rayCount", static_cast<std::int32_t>(count));
      const auto keep = [&](std::size_t i, const Answer& answer) {
        requireWhole(*context_, answer);
        take(first + i, answer);
      };
      seconds += options_.stage == Stage::fragment ? draw(program, count, counting, keep)
                                                   : dispatch(program, count, counting, keep);
    }
    return seconds;
  }

  template <class Take>
  double draw(Program& program, std::size_t count, bool counting, const Take& take) {
    const auto width = std::min<std::size_t>(count, kTargetWidth);
    const std::size_t height = (count + width - 1) / width;
    FloatTarget target(*context_, static_cast<int>(width), static_cast<int>(height), kAttachments);
    program.set("targetWidth", target.width());
    timer_.start();
    target.draw(program);
    timer_.stop();
    std::vector<std::vector<float>> pictures(counting ? kAttachments : 1);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      pictures[i].resize(4 * width * height);
      target.read(pictures[i], static_cast<int>(i));
    }
    for (std::size_t i = 0; i < count; ++i) {
      Answer answer{};
      for (std::size_t j = 0; j < kAnswerFloats && j / 4 < pictures.size(); ++j) {
        answer[j] = pictures[j / 4][4 * i + j % 4];
      }
      take(i, answer);
    }
    return timer_.wallSeconds();
  }

  template <class Take>
  double dispatch(Program& program, std::size_t count, bool counting, const Take& take) {
    const std::size_t stride = counting ? kAnswerFloats : 2;
    StorageBuffer storage(*context_, count * stride * sizeof(float));
    storage.bind(0);
    timer_.start();
    program.dispatch({(static_cast<std::uint32_t>(count) + kGroupSize - 1) / kGroupSize, 1, 1});
    timer_.stop();
    std::vector<float> floats(count * stride);
    storage.read(std::as_writable_bytes(std::span(floats)));
    for (std::size_t i = 0; i < count; ++i) {
      Answer answer{};
      std::copy_n(&floats[i * stride], stride, answer.begin());
      take(i, answer);
    }
    return timer_.wallSeconds();
  }

  std::shared_ptr<const FlatScene> scene_;
  RenderOptions options_;
  std::unique_ptr<Context> context_;
  ProgramCache programs_;
  std::optional<SceneTextures> textures_;
  std::shared_ptr<Program> program_;
  std::shared_ptr<Program> counting_;
  TimerQuery timer_;
};

}  // namespace

std::unique_ptr<HullCaster> makeGpuHullCaster(std::shared_ptr<const FlatScene> scene,
                                              const RenderOptions& options) {
  refuseCpuOptions(options);
  if (scene->index.primitiveCount() > kMostPrimitives) {
    throw UsageError("found " + std::to_string(scene->index.primitiveCount()) +
                     " primitives, expected at most " + std::to_string(kMostPrimitives) +
                     " for hulls on the gpu");
  }
  return std::make_unique<GpuHullCaster>(std::move(scene), options);
}

}  // namespace twintrace
