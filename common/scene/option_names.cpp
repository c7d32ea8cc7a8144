#include "common/scene/option_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <limits>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/hulls/hull_structure.h"
#include "common/scene/effects.h"

namespace twintrace {

namespace {

template <class Value>
struct Choice {
  std::string_view text;
  Value value;
};
template <class Value>
Choice(std::string_view, Value) -> Choice<Value>;

constexpr std::array kBackEnds = {Choice{"cpu", BackEnd::cpu}, Choice{"gpu", BackEnd::gpu}};
constexpr std::array kIntegrators = {
    Choice{"path", Integrator::path}, Choice{"report", Integrator::report},
    Choice{"whitted", Integrator::whitted}, Choice{"local", Integrator::local}};
constexpr std::array kNoises = {Choice{"pcg", Noise::pcg}, Choice{"sine", Noise::sine}};
constexpr std::array kMaths = {Choice{"strict", Maths::strict}, Choice{"native", Maths::native}};
constexpr std::array kPrecisions = {Choice{"float", Precision::float32},
                                    Choice{"double", Precision::float64}};
constexpr std::array kLanes = {Choice{"wide", Lanes::wide}, Choice{"scalar", Lanes::scalar}};
constexpr std::array kIntersectors = {Choice{"robust", Intersector::robust},
                                      Choice{"report", Intersector::report}};
constexpr std::array kGeometries = {Choice{"auto", Geometry::automatic},
                                    Choice{"literal", Geometry::literal},
                                    Choice{"buffer", Geometry::buffer}};
constexpr std::array kProviders = {Choice{"osmesa", Provider::osmesa},
                                   Choice{"egl", Provider::egl}};
constexpr std::array kStages = {Choice{"fragment", Stage::fragment},
                                Choice{"compute", Stage::compute}};

/// Largest spp and first sample: the index after the last sample, rounded up to a whole frame,
/// stays below 2^31.
constexpr std::int64_t kMaxSamples = std::int64_t{1} << 30;
constexpr std::int64_t kMaxThreads = 4096;
constexpr double kMaxSeconds = 1e9;

using Implication = void (*)(RenderOptions&);

void impliesNothing(RenderOptions&) {}

void impliesLanes(RenderOptions& options) {
  options.lanesGiven = true;
}

void impliesIntersectorGiven(RenderOptions& options) {
  options.intersectorGiven = true;
}

void impliesIntersector(RenderOptions& options) {
  if (options.intersectorGiven) return;
  const bool report = options.integrator == Integrator::report;
  options.intersector = report ? Intersector::report : Intersector::robust;
}

template <auto Field, const auto& Choices, Implication implied>
bool setChoice(RenderOptions& options, const OptionValue& value) {
  const auto& text = std::get<std::string>(value);
  for (const auto& choice : Choices) {
    if (choice.text != text) continue;
    options.*Field = choice.value;
    implied(options);
    return true;
  }
  return false;
}

template <auto Field, const auto& Choices>
std::string getChoice(const RenderOptions& options) {
  for (const auto& choice : Choices) {
    if (options.*Field == choice.value) return std::string(choice.text);
  }
  return "";
}

template <auto Field, const auto& Choices, Implication implied = impliesNothing>
Option choiceOption(std::string name) {
  std::vector<std::string> words;
  for (const auto& choice : Choices) words.emplace_back(choice.text);
  std::string expected = oneOf(words);
  return {std::move(name),
          OptionType::text,
          std::move(expected),
          std::move(words),
          setChoice<Field, Choices, implied>,
          getChoice<Field, Choices>};
}

template <auto Field, std::int64_t low, std::int64_t high>
bool setInteger(RenderOptions& options, const OptionValue& value) {
  const auto number = std::get<std::int64_t>(value);
  if (number < low || number > high) return false;
  options.*Field = static_cast<std::remove_reference_t<decltype(options.*Field)>>(number);
  return true;
}

template <auto Field>
std::string getNumber(const RenderOptions& options) {
  return fmt::format("{}", options.*Field);
}

template <auto Field, std::int64_t low, std::int64_t high>
Option integerOption(std::string name) {
  return {std::move(name),
          OptionType::integer,
          fmt::format("an integer from {} to {}", low, high),
          {},
          setInteger<Field, low, high>,
          getNumber<Field>};
}

/// Written so that NaN fails.
bool inRange(double value, double high) {
  return value >= 0 && value <= high;
}

bool setTime(RenderOptions& options, const OptionValue& value) {
  const bool allowed = inRange(std::get<double>(value), kMaxSeconds);
  if (allowed) options.timeLimit = std::get<double>(value);
  return allowed;
}

bool setTargetError(RenderOptions& options, const OptionValue& value) {
  const bool allowed = inRange(std::get<double>(value), 1.0);
  if (allowed) options.targetError = std::get<double>(value);
  return allowed;
}

bool isEffectChoice(const std::string& text) {
  if (text == "auto" || text == "all") return true;
  try {
    effectsFromList(text);
    return true;
  } catch (const UsageError&) {
    return false;
  }
}

bool setEffects(RenderOptions& options, const OptionValue& value) {
  const auto& text = std::get<std::string>(value);
  const bool allowed = isEffectChoice(text);
  if (allowed) options.effects = text;
  return allowed;
}

std::string getEffects(const RenderOptions& options) {
  return options.effects;
}

Option effectsOption() {
  const std::vector<std::string> names(kEffectNames.begin(), kEffectNames.end());
  return {"effects", OptionType::text, "auto, all or a comma-separated list of " + oneOf(names),
          {},        setEffects,       getEffects};
}

std::vector<std::string> hullChoices() {
  std::vector<std::string> names = {"auto"};
  for (const HullStrategy& strategy : hullStrategies()) names.push_back(strategy.name);
  names.emplace_back("embree");
  return names;
}

bool setHull(RenderOptions& options, const OptionValue& value) {
  const auto& text = std::get<std::string>(value);
  const std::vector<std::string> choices = hullChoices();
  const bool allowed = std::ranges::find(choices, text) != choices.end();
  if (allowed) options.hull = text;
  return allowed;
}

std::string getHull(const RenderOptions& options) {
  return options.hull;
}

Option hullOption() {
  const std::vector<std::string> choices = hullChoices();
  return {"hull", OptionType::text, oneOf(choices), choices, setHull, getHull};
}

std::vector<Option> buildTable() {
  using O = RenderOptions;
  return {
      choiceOption<&O::backend, kBackEnds>("backend"),
      integerOption<&O::width, 1, kMaxPixels>("width"),
      integerOption<&O::height, 1, kMaxPixels>("height"),
      integerOption<&O::spp, 1, kMaxSamples>("spp"),
      integerOption<&O::passes, 1, kMaxPasses>("passes"),
      integerOption<&O::bounces, 0, kMaxBounces>("bounces"),
      integerOption<&O::seed, 0, std::numeric_limits<std::uint32_t>::max()>("seed"),
      integerOption<&O::firstSample, 0, kMaxSamples>("first-sample"),
      {"time",
       OptionType::number,
       "seconds from 0 (no limit) to 1e9",
       {},
       setTime,
       getNumber<&O::timeLimit>},
      {"target-error",
       OptionType::number,
       "a relative error from 0 (none) to 1",
       {},
       setTargetError,
       getNumber<&O::targetError>},
      choiceOption<&O::integrator, kIntegrators, impliesIntersector>("integrator"),
      choiceOption<&O::noise, kNoises>("noise"),
      choiceOption<&O::maths, kMaths>("maths"),
      choiceOption<&O::precision, kPrecisions>("precision"),
      choiceOption<&O::lanes, kLanes, impliesLanes>("lanes"),
      choiceOption<&O::intersector, kIntersectors, impliesIntersectorGiven>("intersector"),
      hullOption(),
      choiceOption<&O::geometry, kGeometries>("geometry"),
      choiceOption<&O::provider, kProviders>("gl"),
      choiceOption<&O::stage, kStages>("stage"),
      integerOption<&O::threads, 0, kMaxThreads>("threads"),
      effectsOption(),
  };
}

std::vector<std::string> optionNames() {
  std::vector<std::string> names;
  for (const Option& option : renderOptionTable()) names.push_back(option.name);
  return names;
}

template <class Number>
std::optional<OptionValue> parseNumber(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return number;
}

/// Length of the first `name=value` of a list: up to the comma before the next part with `=`.
std::size_t assignmentLength(std::string_view list) {
  const std::size_t nextEquals = list.find('=', list.find('=') + 1);
  if (nextEquals == std::string_view::npos) return list.size();
  const std::size_t comma = list.rfind(',', nextEquals);
  return comma == std::string_view::npos ? list.size() : comma;
}

void setAssignment(RenderOptions& options, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    throw UsageError("found " + quote(assignment) + ", expected name=value,name=value");
  }
  setOption(options, assignment.substr(0, equals), assignment.substr(equals + 1));
}

}  // namespace

const std::vector<Option>& renderOptionTable() {
  static const std::vector<Option> table = buildTable();
  return table;
}

const Option* findOption(std::string_view name) {
  const std::vector<Option>& table = renderOptionTable();
  const auto named = [&](const Option& option) { return option.name == name; };
  const auto found = std::find_if(table.begin(), table.end(), named);
  return found == table.end() ? nullptr : &*found;
}

std::optional<OptionValue> parseOptionValue(OptionType type, std::string_view text) {
  switch (type) {
    case OptionType::integer:
      return parseNumber<std::int64_t>(text);
    case OptionType::number:
      return parseNumber<double>(text);
    case OptionType::text:
      return std::string(text);
  }
  return std::nullopt;
}

void setOption(RenderOptions& options, std::string_view name, std::string_view text) {
  const Option* option = findOption(name);
  if (option == nullptr) {
    const std::vector<std::string> names = optionNames();
    throw UsageError(fmt::format("found option {}, expected one of {}{}", quote(name), oneOf(names),
                                 didYouMean(name, names)));
  }
  const std::optional<OptionValue> value = parseOptionValue(option->type, text);
  if (value && option->set(options, *value)) return;
  throw UsageError(fmt::format("{}: found {}, expected {}{}", option->name, quote(text),
                               option->expected, didYouMean(text, option->choices)));
}

void setOptions(RenderOptions& options, std::string_view list) {
  while (!list.empty()) {
    const std::size_t length = assignmentLength(list);
    setAssignment(options, list.substr(0, length));
    list.remove_prefix(std::min(list.size(), length + 1));
  }
}

std::vector<std::pair<std::string, std::string>> listOptions(const RenderOptions& options) {
  std::vector<std::pair<std::string, std::string>> list;
  for (const Option& option : renderOptionTable())
    list.emplace_back(option.name, option.get(options));
  return list;
}

std::optional<std::string> filmConflict(const RenderOptions& options) {
  const std::int64_t pixels = std::int64_t{options.width} * options.height;
  if (pixels <= kMaxPixels) return std::nullopt;
  return fmt::format("found a film of {} x {} pixels, expected at most {} pixels", options.width,
                     options.height, kMaxPixels);
}

std::optional<std::string> sampleConflict(const RenderOptions& options) {
  if (options.firstSample % options.passes == 0) return std::nullopt;
  return fmt::format("found first-sample {} with passes {}, expected a multiple of passes",
                     options.firstSample, options.passes);
}

void checkOptions(const RenderOptions& options) {
  if (const auto conflict = filmConflict(options)) throw UsageError(*conflict);
  if (const auto conflict = sampleConflict(options)) throw UsageError(*conflict);
}

}  // namespace twintrace
