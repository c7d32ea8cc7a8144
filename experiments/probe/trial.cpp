#include "experiments/probe/trial.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <span>

#include "common/base/error.h"
#include "common/base/float_bits.h"
#include "common/base/wording.h"
#include "experiments/probe/inputs.h"
#include "experiments/probe/reference.h"

namespace twintrace::probe {
namespace {

// Records around each worst one, a second round: enough to move every word of it by each distance
// that drawNear() has.
constexpr std::size_t kNearCount = 4096;

constexpr std::uint32_t kNoDistance = 0xffffffffu;

std::string withoutSpaces(const std::string& text) {
  std::string kept;
  std::ranges::copy_if(text, std::back_inserter(kept), [](char c) { return c != ' '; });
  return kept;
}

/// Denormals are zero in strict maths; one that is only passed on may survive.
float flushed(std::uint32_t word) {
  return (word & 0x7f800000u) == 0u ? 0.0f : std::bit_cast<float>(word);
}

/// The answers of all to many records, in one world.
struct Answers {
  std::vector<std::uint32_t> inputs;
  std::vector<std::uint32_t> gpu;
  std::vector<std::uint32_t> twin;
  std::vector<double> twin64;
};

/// One function on trial in one world.
class WorldTrial {
 public:
  WorldTrial(Context& context, const ShaderLibrary& library, const ShaderFunction& function,
             const World& world, FunctionTrial& result)
      : context_(context),
        library_(library),
        function_(function),
        world_(world),
        kinds_(outputKinds(function)),
        reference_(referenceOf(function.signature)),
        result_(result) {}

  void add(std::vector<std::uint32_t> inputs) {
    const Answers answers = answersTo(std::move(inputs));
    const std::size_t count = answers.gpu.size() / kinds_.size();
    for (std::size_t i = 0; i < count; ++i) addRecord(answers, i);
    result_.records += count;
  }

  Record recordOf(const Answers& answers, std::size_t index) const {
    Record record{world_.name, part(answers.inputs, index, inputCount()),
                  part(answers.gpu, index, kinds_.size()), part(answers.twin, index, kinds_.size()),
                  {}, {}};
    if (!answers.twin64.empty()) record.twin64 = part(answers.twin64, index, kinds_.size());
    std::vector<float> expected(kinds_.size());
    if (hasReference(answers, index, expected)) record.reference = expected;
    return record;
  }

  Answers answersTo(std::vector<std::uint32_t> inputs) const {
    Answers answers;
    answers.inputs = std::move(inputs);
    answers.gpu = runShader(context_, library_, function_, world_, answers.inputs);
    if (function_.twin != nullptr) answers.twin = runTwin(function_, world_, answers.inputs);
    if (function_.twin64 != nullptr) answers.twin64 = runTwin64(function_, world_, answers.inputs);
    return answers;
  }

 private:
  std::size_t inputCount() const { return static_cast<std::size_t>(inputWords(function_)); }

  template <class Word>
  static std::vector<Word> part(const std::vector<Word>& all, std::size_t index, std::size_t size) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(index * size);
    return {begin, begin + static_cast<std::ptrdiff_t>(size)};
  }

  bool hasReference(const Answers& answers, std::size_t index, std::vector<float>& expected) const {
    if (reference_ == nullptr) return false;
    std::vector<float> given;
    for (const std::uint32_t word : part(answers.inputs, index, inputCount())) {
      given.push_back(std::bit_cast<float>(word));
    }
    return reference_->answer(given.data(), expected.data());
  }

  void addRecord(const Answers& answers, std::size_t index) {
    const std::uint32_t* gpu = &answers.gpu[index * kinds_.size()];
    const auto farthest = [&](const auto& wordAt) {
      std::uint32_t ulps = 0;
      for (std::size_t i = 0; i < kinds_.size(); ++i) {
        ulps = std::max(ulps, wordDistance(kinds_[i], gpu[i], wordAt(i)));
      }
      return ulps;
    };
    const std::size_t at = index * kinds_.size();
    const auto toTwin = farthest([&](std::size_t i) { return answers.twin[at + i]; });
    if (toTwin != 0) ++result_.differing;
    note(result_.toTwin, toTwin, answers, index);
    if (!answers.twin64.empty()) {
      if (!result_.toTwin64) result_.toTwin64.emplace();
      const auto ulps =
          farthest([&](std::size_t i) { return wordOf(kinds_[i], answers.twin64[at + i]); });
      note(*result_.toTwin64, ulps, answers, index);
    }
    std::vector<float> expected(kinds_.size());
    if (hasReference(answers, index, expected)) {
      if (!result_.toReference) result_.toReference.emplace();
      const auto ulps =
          farthest([&](std::size_t i) { return std::bit_cast<std::uint32_t>(expected[i]); });
      note(*result_.toReference, ulps, answers, index);
    }
  }

  /// Any distance is worse than none that can be told, since it leads on to still worse inputs.
  void note(Distances& distances, std::uint32_t ulps, const Answers& answers, std::size_t index) {
    distances.ulps.add(ulps);
    if (ulps == 0) return;
    const bool worse = ulps != kNoDistance && ulps > distances.worstUlps;
    if (!worse && distances.worst) return;
    distances.worst = recordOf(answers, index);
    if (ulps != kNoDistance) distances.worstUlps = ulps;
  }

  Context& context_;
  const ShaderLibrary& library_;
  const ShaderFunction& function_;
  const World& world_;
  std::vector<Kind> kinds_;
  const Reference* reference_;
  FunctionTrial& result_;
};

/// Inputs around the worst records that were found in the world.
std::vector<std::uint32_t> nearWorst(const FunctionTrial& result, const World& world,
                                     std::uint64_t seed) {
  std::vector<std::uint32_t> inputs;
  for (const Distances* distances :
       {&result.toTwin, result.toTwin64 ? &*result.toTwin64 : nullptr,
        result.toReference ? &*result.toReference : nullptr}) {
    if (distances == nullptr || !distances->worst || distances->worst->world != world.name) continue;
    const auto near = drawNear(*result.function, distances->worst->inputs, kNearCount, seed);
    inputs.insert(inputs.end(), near.begin(), near.end());
  }
  return inputs;
}

Verdict startVerdict(const ShaderFunction& function, Maths maths) {
  if (function.twin == nullptr) return Verdict::noTwin;
  return maths == Maths::native && !function.inNative ? Verdict::notInNative : Verdict::identical;
}

}  // namespace

const char* verdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::identical:
      return "identical";
    case Verdict::differs:
      return "differs";
    case Verdict::noTwin:
      return "no twin";
    case Verdict::notInNative:
      return "not in native maths";
  }
  return "";
}

std::vector<const ShaderFunction*> chooseFunctions(const std::vector<std::string>& names) {
  const auto all = shaderFunctions();
  if (names.empty()) return all;
  std::vector<std::string> known;
  for (const ShaderFunction* function : all) {
    known.emplace_back(function->name);
    known.emplace_back(function->signature);
  }
  std::vector<const ShaderFunction*> chosen;
  for (const std::string& name : names) {
    const std::size_t before = chosen.size();
    for (const ShaderFunction* function : all) {
      const bool named =
          name == function->name || withoutSpaces(name) == withoutSpaces(function->signature);
      if (named) chosen.push_back(function);
    }
    if (chosen.size() == before) {
      throw UsageError("found function " + quote(name) +
                       ", expected a function of the shaders or its signature, as in dot3 or "
                       "\"dot3(vec3, vec3)\"" + didYouMean(name, known));
    }
  }
  return chosen;
}

FunctionTrial tryFunction(Context& context, const ShaderLibrary& library,
                          const ShaderFunction& function, const TrialSettings& settings) {
  const auto start = std::chrono::steady_clock::now();
  FunctionTrial result;
  result.function = &function;
  result.verdict = startVerdict(function, settings.maths);
  if (result.verdict != Verdict::identical) return result;
  for (World& world : worldsFor(function)) {
    world.options.maths = settings.maths;
    WorldTrial trial(context, library, function, world, result);
    trial.add(drawInputs(function, world, settings.samples, settings.seed));
    if (const auto boundaries = boundaryInputs(function); !boundaries.empty()) trial.add(boundaries);
    const auto near = nearWorst(result, world, settings.seed);
    if (!near.empty()) trial.add(near);
  }
  if (result.differing != 0) result.verdict = Verdict::differs;
  result.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

Record replay(Context& context, const ShaderLibrary& library, const ShaderFunction& function,
              const World& world, const std::vector<std::uint32_t>& inputs) {
  FunctionTrial unused;
  const WorldTrial trial(context, library, function, world, unused);
  return trial.recordOf(trial.answersTo(inputs), 0);
}

std::uint32_t wordDistance(Kind kind, std::uint32_t a, std::uint32_t b) {
  if (kind == Kind::real) return ulpDistance(flushed(a), flushed(b));
  return a == b ? 0u : kNoDistance;
}

bool differ(const ShaderFunction& function, const std::vector<std::uint32_t>& a,
            const std::vector<std::uint32_t>& b) {
  const std::vector<Kind> kinds = outputKinds(function);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (wordDistance(kinds[i], a[i], b[i]) != 0) return true;
  }
  return false;
}

std::uint32_t wordOf(Kind kind, double value) {
  switch (kind) {
    case Kind::real:
      return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    case Kind::integer:
      return static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    case Kind::natural:
      return static_cast<std::uint32_t>(value);
    case Kind::truth:
      return value != 0.0 ? 1u : 0u;
  }
  return 0;
}

}  // namespace twintrace::probe
