#include "gpu/case_engine.h"

#include <algorithm>
#include <bit>

#include "common/base/error.h"
#include "common/cast/case_texels.h"
#include "common/scene/layout.h"
#include "gpu/buffers.h"
#include "gpu/context.h"
#include "gpu/passport_cache.h"
#include "gpu/program_cache.h"
#include "gpu/provider.h"
#include "gpu/scene_uniforms.h"
#include "gpu/specialisation.h"

namespace twintrace {
namespace {

static_assert(kBounceNotStarted == layout::kCaseNotStarted);

constexpr std::uint32_t kGroupSize = 64;  // local_size of mains/cast.glsl
constexpr std::size_t kChunk = 1u << 20;  // rays per dispatch: 64 MiB of ray texels
constexpr int kTargetSide = 1024;         // of the fragment stage's picture: a pixel per ray
constexpr std::size_t kAnswerFloats = layout::kCaseAnswerFloats;
// Primitives come back as floats, which the fragment stage has for outputs.
constexpr std::size_t kMaxPrimitives = 1u << 24;

/// A scene without anything in it: cases bring their own primitives.
FlatScene emptyScene() {
  FlatScene scene;
  scene.texels.emplace_back(0u);
  return scene;
}

ShaderRequest castRequest(const FlatScene& scene, const RenderOptions& options,
                          const Corrections& corrections) {
  ShaderRequest request = specialise(scene, options, corrections);
  request.main = options.stage == Stage::fragment ? "mains/cast_fragment.glsl" : "mains/cast.glsl";
  return request;
}

std::uint32_t word(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

void addRay(std::vector<glm::uvec4>& texels, const CastRay& ray, const CaseRange& range,
            const Bounce* bounce) {
  const Bounce random = bounce == nullptr ? Bounce(0.0f) : *bounce;
  texels.emplace_back(word(ray.origin.x), word(ray.origin.y), word(ray.origin.z), word(ray.tmin));
  texels.emplace_back(word(ray.direction.x), word(ray.direction.y), word(ray.direction.z),
                      word(ray.tmax));
  texels.emplace_back(range.firstTexel, range.count, word(range.reach),
                      bounce == nullptr ? 0u : 1u);
  texels.emplace_back(word(random.x), word(random.y), 0u, 0u);
}

CastHit hitOf(const float* answer) {
  return {answer[0], static_cast<std::int32_t>(answer[4]), {answer[1], answer[2], answer[3]}};
}

/// Runs a program over the rays of a chunk and gives kAnswerFloats of each.
class CastStage {
 public:
  virtual ~CastStage() = default;
  virtual void run(Program& program, std::size_t count, std::span<float> answers) = 0;
};

class ComputeCast : public CastStage {
 public:
  ComputeCast(Context& context, std::size_t rayCount)
      : storage_(context, rayCount * kAnswerFloats * sizeof(float)) {}

  void run(Program& program, std::size_t count, std::span<float> answers) override {
    storage_.bind(0);
    const auto groups = (static_cast<std::uint32_t>(count) + kGroupSize - 1) / kGroupSize;
    program.dispatch({groups, 1, 1});
    storage_.read(std::as_writable_bytes(answers));
  }

 private:
  StorageBuffer storage_;
};

class FragmentCast : public CastStage {
 public:
  FragmentCast(Context& context, std::size_t rayCount)
      : target_(context, width(rayCount), height(rayCount), 2),
        first_(pixelFloats()),
        second_(pixelFloats()) {}

  void run(Program& program, std::size_t count, std::span<float> answers) override {
    program.set("targetWidth", target_.width());
    target_.draw(program);
    target_.read(first_, 0);
    target_.read(second_, 1);
    for (std::size_t i = 0; i < count; ++i) {
      float* answer = &answers[kAnswerFloats * i];
      std::copy_n(&first_[4 * i], 4, answer);
      answer[4] = second_[4 * i];
    }
  }

 private:
  static int width(std::size_t rayCount) {
    return static_cast<int>(std::min<std::size_t>(rayCount, kTargetSide));
  }
  static int height(std::size_t rayCount) {
    return static_cast<int>((rayCount + kTargetSide - 1) / kTargetSide);
  }
  std::size_t pixelFloats() const {
    return std::size_t{4} * static_cast<std::size_t>(target_.width()) *
           static_cast<std::size_t>(target_.height());
  }

  FloatTarget target_;
  std::vector<float> first_;
  std::vector<float> second_;
};

class GpuCaseEngine : public CaseEngine {
 public:
  GpuCaseEngine(const RenderOptions& options, const ShaderLibrary& library)
      : options_(options),
        scene_(emptyScene()),
        context_(createContext(options.provider, options.threads)),
        programs_(*context_) {
    options_.geometry = Geometry::buffer;
    const Context::Current current = context_->use();
    const Corrections corrections = passportOf(*context_, library).corrections;
    program_ = programs_.get(
        options_.stage, assembleShader(library, castRequest(scene_, options_, corrections)));
  }

  std::vector<CastHit> cast(const CaseSet& cases) override {
    std::vector<CastHit> hits(cases.rays.size());
    if (hits.empty()) return hits;
    const CaseTexels packed = packCases(cases);
    requireIndices(packed);
    const Context::Current current = context_->use();
    const BufferTexture primitives(*context_, packed.texels);
    primitives.bind(0);
    setSceneUniforms(*program_, scene_, options_);
    program_->set("rayTexels", 1);
    const auto stage = makeStage(std::min(hits.size(), kChunk));
    for (std::size_t first = 0; first < hits.size(); first += kChunk) {
      const std::size_t count = std::min(kChunk, hits.size() - first);
      castChunk(cases, packed, first, *stage, std::span(hits).subspan(first, count));
    }
    return hits;
  }

  std::string name() const override { return "gpu"; }

 private:
  static void requireIndices(const CaseTexels& packed) {
    for (const CaseRange& scene : packed.scenes) {
      if (static_cast<std::size_t>(scene.count) <= kMaxPrimitives) continue;
      throw UsageError("found " + std::to_string(scene.count) +
                       " primitives in a scene, expected at most " +
                       std::to_string(kMaxPrimitives) + " on engine gpu");
    }
  }

  std::unique_ptr<CastStage> makeStage(std::size_t rayCount) {
    if (options_.stage == Stage::fragment) {
      return std::make_unique<FragmentCast>(*context_, rayCount);
    }
    return std::make_unique<ComputeCast>(*context_, rayCount);
  }

  void castChunk(const CaseSet& cases, const CaseTexels& packed, std::size_t first,
                 CastStage& stage, std::span<CastHit> hits) {
    std::vector<glm::uvec4> texels;
    texels.reserve(hits.size() * layout::kCaseRayTexels);
    for (std::size_t i = first; i < first + hits.size(); ++i) {
      const CaseRay& ray = cases.rays[i];
      addRay(texels, normalised(ray.ray), packed.scenes[ray.scene],
             cases.bounces.empty() ? nullptr : &cases.bounces[i]);
    }
    const BufferTexture rays(*context_, texels);
    rays.bind(1);
    program_->set("rayCount", static_cast<std::int32_t>(hits.size()));
    std::vector<float> answers(hits.size() * kAnswerFloats);
    stage.run(*program_, hits.size(), answers);
    for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = hitOf(&answers[kAnswerFloats * i]);
  }

  RenderOptions options_;
  FlatScene scene_;
  std::unique_ptr<Context> context_;
  ProgramCache programs_;
  std::shared_ptr<Program> program_;
};

}  // namespace

std::unique_ptr<CaseEngine> makeGpuCaseEngine(const RenderOptions& options,
                                              const ShaderLibrary& library) {
  if (options.precision == Precision::float64) {
    throw UsageError(
        "precision double with engine gpu, expected engine cpu64: shaders compute in "
        "float");
  }
  return std::make_unique<GpuCaseEngine>(options, library);
}

}  // namespace twintrace
