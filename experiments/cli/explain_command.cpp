#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/scene/option_names.h"
#include "experiments/arm.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/scene_input.h"
#include "experiments/cli/shared_options.h"
#include "experiments/compare_arms.h"
#include "experiments/explain/explain_text.h"
#include "experiments/explain/plain_sample.h"
#include "experiments/probe/replay_command.h"

namespace twintrace {
namespace {

PixelPosition parsePixel(const std::string& text, const RenderOptions& options) {
  PixelPosition pixel;
  const char* end = text.data() + text.size();
  const auto x = std::from_chars(text.data(), end, pixel.x);
  bool valid = x.ec == std::errc{} && x.ptr != end && *x.ptr == ',';
  if (valid) {
    const auto y = std::from_chars(x.ptr + 1, end, pixel.y);
    valid = y.ec == std::errc{} && y.ptr == end;
  }
  if (!valid) throw UsageError("pixel: found " + quote(text) + ", expected X,Y");
  if (pixel.x >= 0 && pixel.y >= 0 && pixel.x < options.width && pixel.y < options.height) {
    return pixel;
  }
  throw UsageError(fmt::format("pixel: found {}, expected x from 0 to {} and y from 0 to {}", text,
                               options.width - 1, options.height - 1));
}

class ExplainCommand {
 public:
  explicit ExplainCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "explain", "say where and why a sample differs between two arms");
    syntax.option("scene", scenePath_, "scene file").required().typeName("SCENE");
    syntax.option("--pixel", pixel_, "column and row from the upper left, from 0")
        .required()
        .typeName("X,Y");
    syntax.option("--sample", sample_, "index of the sample; the first that differs unless said");
    syntax.option("--a", listA_, "options of arm a; its backend is cpu unless said")
        .typeName("KEY=VAL,...");
    syntax.option("--b", listB_, "options of arm b; its backend is gpu unless said")
        .typeName("KEY=VAL,...");
    addAnswerOptions(syntax, answer_);
    addRenderOptions(syntax, given_);
    return syntax.app();
  }

  int run() {
    const Scene scene = openScene(console_, scenePath_);
    const ArmOptions options{armOptions(scene.render, "cpu", listA_),
                             armOptions(scene.render, "gpu", listB_)};
    checkArms(options);
    ExplainedSample about;
    about.pixel = parsePixel(pixel_, options.a);
    about.sample = sample_.value_or(0);
    checkSample(options.a);
    checkAnswer(answer_);
    Arm armA = openArm(scene, options.a);
    Arm armB = openArm(scene, options.b);
    const auto a = makePathTracer(armA.scene, options.a, TraceDetail::statements);
    const auto b = makePathTracer(armB.scene, options.b, TraceDetail::statements);
    auto result = findSample(*a, *b, options.a, about);
    const bool native =
        options.a.maths == Maths::native || options.b.maths == Maths::native;
    if (!sample_ && result->sameRadiance && findPlainSample(armA, armB, about)) {
      result = explain(*a, *b, about);
    }
    const PlainSample plain = renderPlainSample(armA, armB, about.pixel, about.sample);
    about.renderedAlike = !plain.differs();
    addNotes("a", options.a, result->traceA, about);
    addNotes("b", options.b, result->traceB, about);
    for (std::string& note : traceNotes(plain, *result, native)) about.notes.push_back(note);
    about.replay = probe::replayCommand(scene, options.a, options.b, *result);
    answer(console_, answer_, explanationJson(*armA.scene, about, *result),
           explanationText(*armA.scene, about, *result));
    return result->sameRadiance && about.renderedAlike ? kAgree : kDiffer;
  }

 private:
  RenderOptions armOptions(const RenderOptions& ofScene, const char* backEnd,
                           const std::string& list) const {
    GivenOptions given = given_;
    if (!given.has("backend")) given.list.emplace_back("backend", backEnd);
    given.armList = list;
    RenderOptions options = layOptions(ofScene, given);
    checkOptions(options);
    return options;
  }

  void checkSample(const RenderOptions& options) const {
    if (!sample_ || (*sample_ >= 0 && *sample_ <= 0xffffffffll)) return;
    throw UsageError(fmt::format("sample: found {}, expected an integer from 0 (--spp is {})",
                                 *sample_, options.spp));
  }

  /// The sample asked for, or the first that differs; if none does, the last.
  std::unique_ptr<SampleExplanation> findSample(PathTracer& a, PathTracer& b,
                                                const RenderOptions& options,
                                                ExplainedSample& about) const {
    const std::int64_t first = sample_.value_or(options.firstSample);
    const std::int64_t last = sample_ ? first : first + std::max(options.spp, 1) - 1;
    std::unique_ptr<SampleExplanation> result;
    for (about.sample = first;; ++about.sample) {
      result = explain(a, b, about);
      if (!result->sameRadiance || about.sample == last) break;
    }
    if (!sample_ && result->sameRadiance) {
      about.notes.push_back(
          fmt::format("none of the samples {} to {} differs; the last is shown", first, last));
    }
    return result;
  }

  static std::unique_ptr<SampleExplanation> explain(PathTracer& a, PathTracer& b,
                                                    const ExplainedSample& about) {
    auto result = std::make_unique<SampleExplanation>();
    explainSample(a, b, about.pixel, static_cast<std::uint32_t>(about.sample), *result);
    return result;
  }

  /// Moves `about` to the first sample in which the plain programs differ: in native maths, or where a
  /// driver neglects `precise`, they may where the traced ones agree. @return whether there is one
  static bool findPlainSample(Arm& a, Arm& b, ExplainedSample& about) {
    const RenderOptions& options = a.options;
    for (std::int64_t i = 0; i < std::max(options.spp, 1); ++i) {
      const std::int64_t sample = options.firstSample + i;
      if (!renderPlainSample(a, b, about.pixel, sample).differs()) continue;
      about.sample = sample;
      about.notes.clear();
      return true;
    }
    return false;
  }

  /// Says how the replay differs from the arm as it renders, and what it could not hold.
  static void addNotes(const char* name, const RenderOptions& options, const CallTrace& trace,
                       ExplainedSample& about) {
    const std::string replay = replayNote(options);
    if (!replay.empty()) about.notes.push_back(fmt::format("{}: {}", name, replay));
    if (trace.lost > 0) {
      about.notes.push_back(
          fmt::format("{}: {} events found no room in the trace; what they were is not known", name,
                      trace.lost));
    }
  }

  Console console_;
  std::string scenePath_;
  std::string pixel_;
  std::optional<std::int64_t> sample_;
  std::string listA_;
  std::string listB_;
  AnswerOptions answer_;
  GivenOptions given_;
};

}  // namespace

Command addExplainCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<ExplainCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
