#include "tests/audit/picture_check.h"

#include <algorithm>
#include <stdexcept>

#include "common/scene/option_names.h"
#include "common/scene/reader.h"
#include "experiments/explain/explanation.h"

namespace twintrace::test {
namespace {

constexpr int kSide = 16;  // pixels
constexpr int kSamples = 4;
constexpr int kPasses = 2;
constexpr std::size_t kMostExplained = 4;

RenderOptions small(RenderOptions options, const std::string& list) {
  options.width = kSide;
  options.height = kSide;
  options.spp = kSamples;
  options.passes = kPasses;
  if (!list.empty()) setOptions(options, list);
  checkOptions(options);
  return options;
}

/// The functions that the samples call, and what is around them, which traces leave out.
std::set<std::string> functionsCalled(PathTracer& tracer, Stage stage) {
  std::set<std::string> names = {"renderPixel", stage == Stage::compute
                                                    ? "main of mains/compute.glsl"
                                                    : "main of mains/fragment.glsl"};
  for (int at = 0; at < kSide * kSide; ++at) {
    const CallTrace trace = tracer.trace({at % kSide, at / kSide}, 0);
    const CallTree tree = buildCallTree(tracer.program(), trace);
    for (std::size_t i = 0; i < tree.calls.size(); ++i) {
      names.emplace(tree.name(static_cast<int>(i)));
    }
  }
  return names;
}

std::vector<PixelPosition> differingPixels(const FrameDifferences& differences) {
  std::vector<PixelPosition> pixels;
  for (int at = 0; at < kSide * kSide; ++at) {
    const PixelPosition pixel{at % kSide, at / kSide};
    if (differences.firstFrame(pixel)) pixels.push_back(pixel);
  }
  return pixels;
}

}  // namespace

Picture::Picture(const PictureChoice& choice, const std::string& root)
    : name_(choice.name),
      scene_(readScene(root + "/" + choice.scene)),
      options_(small(scene_.render, choice.options)),
      flat_(flattenScene(scene_, options_)),
      cpu_(openArm(scene_, options_)),
      traced_(makePathTracer(flat_, options_, TraceDetail::calls)),
      called_(functionsCalled(*traced_, options_.stage)) {}

bool Picture::calls(const Damage& damage) const {
  return std::ranges::any_of(damage.functions,
                             [&](const FunctionText& f) { return called_.contains(f.name); });
}

Arm Picture::openGpu(const std::vector<ShaderReplacement>& shaders) const {
  RenderOptions options = options_;
  options.backend = BackEnd::gpu;
  options.shaderOverrides = shaders;
  return openArm(scene_, options);
}

ArmsComparison Picture::compare(const Damage& damage) {
  Arm gpu = openGpu({damage.shader});
  ArmsComparison result = compareArms(cpu_, gpu, true, {}, {});
  if (result.comparison.verdict != Verdict::identical) requireSound();
  return result;
}

void Picture::requireSound() {
  if (sound_) return;
  Arm gpu = openGpu({});
  const ArmsComparison result = compareArms(cpu_, gpu, true, {}, {});
  if (result.comparison.verdict != Verdict::identical) {
    throw std::logic_error("the arms of " + name_ + " differ without a fault");
  }
  sound_ = true;
}

Explained Picture::explain(const Damage& damage, const ArmsComparison& comparison) const {
  RenderOptions options = options_;
  options.backend = BackEnd::gpu;
  options.shaderOverrides = {damage.shader};
  const auto gpu = makePathTracer(flat_, options, TraceDetail::calls);
  const std::vector<PixelPosition> pixels = differingPixels(comparison.differences.value());
  const std::size_t count = std::min(pixels.size(), kMostExplained);
  Explained explained;
  for (std::size_t i = 0; i < count; ++i) {
    const PixelPosition& pixel = pixels[(2 * i + 1) * pixels.size() / (2 * count)];
    const std::uint32_t frame = comparison.differences->firstFrame(pixel).value();
    explained.functions.insert(culprit(*gpu, pixel, frame, explained.kind));
    ++explained.pixels;
  }
  return explained;
}

std::string Picture::culprit(PathTracer& gpu, const PixelPosition& pixel, std::uint32_t frame,
                             std::string& kind) const {
  const std::uint32_t first = frame * kPasses;
  for (std::uint32_t sample = first; sample < first + kPasses; ++sample) {
    SampleExplanation result;
    explainSample(*traced_, gpu, pixel, sample, result);
    if (result.sameRadiance) continue;
    if (kind.empty()) kind = className(result.kind);
    if (!result.divergence) return "nothing";
    return std::string(result.treeA.name(result.divergence->a));
  }
  return "no sample";
}

PictureCheck::PictureCheck(std::vector<PictureChoice> choices, std::string root)
    : choices_(std::move(choices)), root_(std::move(root)), pictures_(choices_.size()) {}

Picture& PictureCheck::picture(std::size_t index) {
  if (!pictures_[index]) pictures_[index] = std::make_unique<Picture>(choices_[index], root_);
  return *pictures_[index];
}

PictureFinding PictureCheck::find(const Damage& damage) {
  PictureFinding finding;
  for (std::size_t i = 0; i < choices_.size(); ++i) {
    if (!picture(i).calls(damage)) continue;
    finding.compare.answer = Answer::no;
    const ArmsComparison result = picture(i).compare(damage);
    if (result.comparison.verdict == Verdict::identical) continue;
    finding.compare = {
        Answer::yes,
        choices_[i].name + ", " + std::to_string(result.comparison.differingPixels) + " pixels"};
    finding.explained = picture(i).explain(damage, result);
    return finding;
  }
  return finding;
}

}  // namespace twintrace::test
