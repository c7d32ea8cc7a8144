#include "experiments/probe/user_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "experiments/probe/trial.h"
#include "experiments/probe/worlds.h"
#include "gpu/specialisation.h"

namespace twintrace::probe {
namespace {

constexpr std::array kSpecialNumbers = {0.0f,  -0.0f,  1.0f,  -1.0f, 0.5f,     2.0f,
                                        -2.0f, 1e-20f, 1e20f, 1e-6f, 0.999999f};
constexpr int kWidestExponent = 10;  // unrestricted floats lie in [2^-10, 2^10]

class InputSource {
 public:
  explicit InputSource(std::uint64_t seed) : engine_(seed) {}

  void append(std::vector<std::uint32_t>& words, const UserValue& value, bool special) {
    if (value.range && value.range->unit) return appendUnit(words, value.size);
    for (int i = 0; i < value.size; ++i) words.push_back(word(value, special));
  }

 private:
  double uniform() { return std::generate_canonical<double, 53>(engine_); }

  void appendUnit(std::vector<std::uint32_t>& words, int size) {
    std::array<double, 4> v{};
    double squared = 0;
    while (squared < 1e-4 || squared > 1) {
      squared = 0;
      for (int i = 0; i < size; ++i) {
        v[static_cast<std::size_t>(i)] = 2 * uniform() - 1;
        squared += v[static_cast<std::size_t>(i)] * v[static_cast<std::size_t>(i)];
      }
    }
    for (int i = 0; i < size; ++i) {
      const double part = v[static_cast<std::size_t>(i)] / std::sqrt(squared);
      words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(part)));
    }
  }

  std::uint32_t word(const UserValue& value, bool special) {
    if (value.kind == Kind::truth) return static_cast<std::uint32_t>(engine_() & 1u);
    if (value.kind == Kind::real) return std::bit_cast<std::uint32_t>(number(value, special));
    const double low = value.range ? value.range->low : value.kind == Kind::integer ? -1000 : 0;
    const double high = value.range ? value.range->high : 1000;
    const double drawn = std::min(std::floor(low + uniform() * (high - low + 1)), high);
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(drawn));
  }

  float number(const UserValue& value, bool special) {
    if (special) {
      const float x = kSpecialNumbers[engine_() % kSpecialNumbers.size()];
      if (!value.range) return x;
      const std::array ends = {value.range->low, value.range->high};
      const bool inside = value.range->low <= x && x <= value.range->high;
      return inside ? x : static_cast<float>(ends[engine_() % ends.size()]);
    }
    if (value.range) {
      const auto& [low, high, unit] = *value.range;
      return static_cast<float>(low + uniform() * (high - low));
    }
    const double size = std::exp2(kWidestExponent * (2 * uniform() - 1));
    return static_cast<float>((engine_() & 1u) != 0 ? size : -size);
  }

  std::mt19937_64 engine_;
};

constexpr std::size_t kSpecialRecords = 1024;

UserReference referenceFor(const UserFunction& function, const ShaderSource& source,
                           const std::string& reference) {
  if (reference.empty()) return textReference(source, function);
  if (reference.ends_with(".h") || reference.ends_with(".hpp")) {
    return headerReference(reference, function);
  }
  return namedReference(reference, function);
}

/// What the GPU runs, with the scene's index as constants: a reference has no uniforms to set.
ShaderSource sourceForReference(const ShaderLibrary& library, const World& world,
                                const RenderOptions& options) {
  ShaderRequest request = specialise(world.scene, options);
  request.main = kUserPath;
  for (const auto& [name, value] : indexConstants(world.scene)) {
    const std::string uniform = fmt::format("uniform int {};", name);
    const std::size_t at = request.prelude.find(uniform);
    if (at == std::string::npos) continue;
    request.prelude.replace(at, uniform.size(), fmt::format("const int {} = {};", name, value));
  }
  return assembleShader(library, request);
}

/// The kind of each word.
std::vector<Kind> kindsOf(const std::vector<UserValue>& values) {
  std::vector<Kind> kinds;
  for (const UserValue& value : values) {
    kinds.insert(kinds.end(), static_cast<std::size_t>(value.size), value.kind);
  }
  return kinds;
}

UserTrial judge(const UserFunction& function, const std::vector<std::uint32_t>& inputs,
                const std::vector<std::uint32_t>& gpu, const UserReference& reference,
                std::uint32_t tolerance) {
  const auto inputWords = static_cast<std::size_t>(wordCount(function.inputs()));
  const std::vector<Kind> kinds = kindsOf(function.outputs());
  UserTrial trial;
  trial.function = function;
  trial.tolerance = tolerance;
  std::vector<double> answer(kinds.size());
  for (std::size_t i = 0; i * inputWords < inputs.size(); ++i) {
    const std::uint32_t* const in = &inputs[i * inputWords];
    const std::uint32_t* const found = &gpu[i * kinds.size()];
    reference(in, answer.data());
    std::uint32_t ulps = 0;
    for (std::size_t word = 0; word < kinds.size(); ++word) {
      const std::uint32_t expected = wordOf(kinds[word], answer[word]);
      ulps = std::max(ulps, wordDistance(kinds[word], found[word], expected));
    }
    trial.ulps.add(ulps);
    ++trial.records;
    if (ulps > tolerance) ++trial.beyond;
    if (ulps > (trial.worst ? trial.worst->ulps : 0)) {
      trial.worst = UserRecord{{in, in + inputWords}, {found, found + kinds.size()}, answer, ulps};
    }
  }
  return trial;
}

std::string distanceText(std::uint32_t ulps) {
  return ulps == std::numeric_limits<std::uint32_t>::max() ? "no" : std::to_string(ulps);
}

std::string wordText(Kind kind, std::uint32_t word) {
  if (kind == Kind::integer) return std::to_string(static_cast<std::int32_t>(word));
  if (kind == Kind::natural) return std::to_string(word);
  if (kind == Kind::truth) return word != 0 ? "true" : "false";
  const auto number = std::bit_cast<float>(word);
  return fmt::format("{:a} ({:.9g})", number, number);
}

/// `name component  value` of each word, with the reference behind where there is one.
std::string valuesText(const std::vector<UserValue>& values,
                       const std::vector<std::uint32_t>& words,
                       const std::vector<double>& reference) {
  constexpr std::string_view kComponents = "xyzw";
  std::string text;
  std::size_t at = 0;
  for (const UserValue& value : values) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(value.size); ++i, ++at) {
      const std::string name =
          value.size == 1 ? value.name : fmt::format("{}.{}", value.name, kComponents[i]);
      text += fmt::format("  {:<12} {}", name, wordText(value.kind, words[at]));
      if (!reference.empty()) {
        const std::uint32_t expected = wordOf(value.kind, reference[at]);
        text += fmt::format("   reference {}   {} ulp", wordText(value.kind, expected),
                            distanceText(wordDistance(value.kind, words[at], expected)));
      }
      text += "\n";
    }
  }
  return text;
}

/// Each word as a number and as its hex text, under its value's name.
Json valuesJson(const std::vector<UserValue>& values, const std::vector<std::uint32_t>& words) {
  Json json = Json::object();
  std::size_t at = 0;
  for (const UserValue& value : values) {
    Json list = Json::array();
    for (int i = 0; i < value.size; ++i) list.push_back(wordText(value.kind, words[at++]));
    json[value.name] = list;
  }
  return json;
}

std::string histogramText(const UlpHistogram& ulps) {
  std::string text;
  for (std::size_t bin = 0; bin < UlpHistogram::kBinCount; ++bin) {
    if (ulps.count(bin) == 0) continue;
    text += fmt::format("  {:>22} ulp {:>9}\n", UlpHistogram::label(bin), ulps.count(bin));
  }
  return text;
}

std::string referenceName(const std::string& reference) {
  return reference.empty() ? "the same text in double" : reference;
}

}  // namespace

std::vector<std::uint32_t> drawUserInputs(const UserFunction& function, std::size_t randomCount,
                                          std::uint64_t seed) {
  const std::vector<UserValue> values = function.inputs();
  const std::size_t count = kSpecialRecords + randomCount;
  InputSource source(seed);
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < count; ++i) {
    for (const UserValue& value : values) source.append(words, value, i < kSpecialRecords);
  }
  // A program needs some input.
  if (values.empty()) words.push_back(0);
  return words;
}

std::vector<UserTrial> tryUserShader(Context& context, const RenderOptions& options,
                                     const UserShader& shader, const UserTrialSettings& settings) {
  World world = plainWorld();
  ShaderLibrary library = shaderLibrary(options);
  library.add(kUserPath, {shader.text, shader.path});
  RenderOptions used = world.options;
  used.maths = options.maths;
  std::vector<UserTrial> trials;
  for (const UserFunction& function : shader.functions) {
    const ShaderSource source = sourceForReference(library, world, used);
    const auto inputs = drawUserInputs(function, settings.samples, settings.seed);
    const auto gpu = runProbe(context, library, userProbe(function), world.scene, used, inputs);
    const UserReference reference = referenceFor(function, source, settings.reference);
    trials.push_back(judge(function, inputs, gpu, reference, settings.tolerance));
    trials.back().reference = referenceName(settings.reference);
  }
  return trials;
}

Json userTrialJson(const UserTrial& trial) {
  Json json = {
      {"function", trial.function.signature}, {"place", trial.function.place.toString()},
      {"reference", trial.reference},         {"verdict", trial.agrees() ? "agrees" : "differs"},
      {"tolerance_ulp", trial.tolerance},     {"records", trial.records},
      {"beyond_tolerance", trial.beyond},     {"max_ulp", trial.ulps.largest()},
      {"histogram", Json::object()},          {"worst", nullptr}};
  for (std::size_t bin = 0; bin < UlpHistogram::kBinCount; ++bin) {
    json["histogram"][UlpHistogram::label(bin)] = trial.ulps.count(bin);
  }
  if (trial.worst) {
    json["worst"] = {{"ulp", trial.worst->ulps},
                     {"inputs", valuesJson(trial.function.inputs(), trial.worst->inputs)},
                     {"gpu", valuesJson(trial.function.outputs(), trial.worst->gpu)},
                     {"reference", trial.worst->reference}};
  }
  return json;
}

std::string userTrialText(const UserTrial& trial) {
  std::string text = fmt::format("{}: {} of {} against {}\n", trial.function.place.toString(),
                                 trial.agrees() ? "agreement" : "DIFFERENCE",
                                 trial.function.signature, trial.reference);
  text += fmt::format("{} of {} inputs agree within {} ulp\n", trial.records - trial.beyond,
                      trial.records, trial.tolerance);
  text += histogramText(trial.ulps);
  if (!trial.worst) return text;
  return text + "worst input:\n" + valuesText(trial.function.inputs(), trial.worst->inputs, {}) +
         "answers:\n" +
         valuesText(trial.function.outputs(), trial.worst->gpu, trial.worst->reference);
}

}  // namespace twintrace::probe
