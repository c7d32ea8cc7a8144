#include "experiments/results_json.h"

#include "common/scene/option_names.h"
#include "experiments/build_info.h"
#include "experiments/effect_ledger.h"
#include "experiments/machine.h"
#include "experiments/shader_hash.h"

namespace twintrace {
namespace {

Json buildJson() {
  const BuildInfo build = buildInfo();
  return {{"compiler", build.compiler}, {"type", build.buildType}, {"flags", build.flags}};
}

template <class Pairs>
Json objectOf(const Pairs& pairs) {
  Json object = Json::object();
  for (const auto& [name, value] : pairs) object[name] = value;
  return object;
}

Json firstDifferenceJson(const std::optional<FirstDifference>& first) {
  if (!first) return nullptr;
  return {{"x", first->pixel.x},
          {"y", first->pixel.y},
          {"sample", first->sample ? Json(*first->sample) : Json(nullptr)},
          {"a", first->a},
          {"b", first->b}};
}

Json equivalenceJson(const Equivalence& equivalence) {
  return {{"bound", equivalence.bound}, {"p", equivalence.p}};
}

Json familyJson(const Comparison& comparison) {
  const FamilyTest& family = comparison.family;
  if (!family.wasRun()) return nullptr;
  return {{"size", family.familySize},
          {"untested", family.untested},
          {"dropped_frames", comparison.droppedFrames},
          {"rejected", family.rejected},
          {"smallest_p", family.smallestP},
          {"permutation_p", family.permutationP},
          {"worst_block", {family.worstBlock.x, family.worstBlock.y}},
          {"worst_channel", family.worstChannel}};
}

/// Keys of design section 9 up to the times.
Json comparisonJson(const Comparison& comparison) {
  const BitComparison& bits = comparison.bits;
  return {{"verdict", verdictName(comparison.verdict)},
          {"paired", comparison.paired},
          {"pixels", bits.pixels},
          {"differing_pixels", comparison.differingPixels},
          {"max_ulp", bits.maxUlp},
          {"ulp_histogram", bits.ulpHistogram},
          {"rmse", bits.rmse},
          {"relmse", bits.relmse},
          {"non_finite_values", bits.nonFiniteValues},
          {"mean_a", bits.meanA},
          {"mean_b", bits.meanB},
          {"z_rejected_fraction", comparison.zRejectedFraction},
          {"family_alpha", comparison.family.alpha},
          {"family", familyJson(comparison)},
          {"equivalence", equivalenceJson(comparison.equivalence)}};
}

/// Share of the explained pixels, and of their difference, by class.
Json classesJson(const DifferenceShares& classes) {
  Json json = Json::object();
  if (classes.examined == 0) return json;
  json["examined_pixels"] = classes.examined;
  for (const auto& [name, share] : classes.byClass) {
    json[name] = {{"pixels", share.pixels}, {"energy", share.energy}};
  }
  return json;
}

void addEnding(Json& json, const Comparison& comparison) {
  json["first_difference"] = firstDifferenceJson(comparison.first);
  json["classes"] = classesJson(comparison.classes);
  json["notes"] = comparison.notes;
}

Json outcomeJson(const ArmOutcome& outcome) {
  return {{"samples", outcome.film.data().ranges.toString()},
          {"passes", outcome.film.passes()},
          {"stopped_by", stopReasonName(outcome.stoppedBy)},
          {"seconds", outcome.seconds},
          {"bad_frames", badFramesJson(outcome.film)}};
}

Json settingsJson(const ComparisonSettings& settings) {
  return {{"alpha", settings.alpha}, {"bound", settings.bound}, {"repeats", settings.repeats}};
}

Json overridesJson(const RenderOptions& options) {
  Json overrides = Json::array();
  for (const ShaderReplacement& replacement : options.shaderOverrides) {
    overrides.push_back({{"shader", replacement.shader},
                         {"file", replacement.file},
                         {"hash", shaderTextHash(replacement.text)}});
  }
  return overrides;
}

}  // namespace

Json machineJson() {
  const CpuFacts cpu = cpuFacts();
  return {{"version", buildInfo().version},
          {"build", buildJson()},
          {"cpu", cpu.model},
          {"hardware_threads", cpu.threads},
          {"libraries", objectOf(libraryVersions())}};
}

Json armJson(const Arm& arm) {
  return {{"options", objectOf(listOptions(arm.options))},
          {"shader_directory", arm.options.shaderDirectory},
          {"shader_overrides", overridesJson(arm.options)},
          {"ran", objectOf(arm.renderer->provenance())},
          {"scene_hash", sceneHash(*arm.scene)},
          {"effects", effectNames(arm.scene->effects)}};
}

Json badFramesJson(const Film& film) {
  Json places = Json::array();
  for (const BadFrame& bad : film.data().badPlaces) {
    places.push_back(
        {{"x", bad.x}, {"y", bad.y}, {"first_sample", bad.firstSample}, {"values", bad.values}});
  }
  return {{"count", film.badFrameCount()}, {"places", places}};
}

Json renderJson(const Scene& scene, const Arm& arm, const RenderResult& result,
                const std::vector<std::string>& outputs) {
  const Film& film = result.film;
  const Image mean = film.mean();
  const double samples = double(result.samplesPerPixel()) * double(mean.pixelCount());
  Json provenance = machineJson();
  provenance["scene"] = scene.path;
  provenance["arm"] = armJson(arm);
  return {{"scene", scene.name},
          {"width", film.width()},
          {"height", film.height()},
          {"samples_per_pixel", result.samplesPerPixel()},
          {"samples", film.data().ranges.toString()},
          {"frames", film.frameCount()},
          {"passes", film.passes()},
          {"stopped_by", stopReasonName(result.stoppedBy)},
          {"seconds", result.seconds},
          {"samples_per_second", samples / result.seconds},
          {"mean", compareBits(mean, mean).meanA},
          {"relative_standard_error", relativeStandardError(film)},
          {"bad_frames", badFramesJson(film)},
          {"outputs", outputs},
          {"provenance", provenance}};
}

Json compareJson(const Scene& scene, const Arm& a, const Arm& b, const ArmsComparison& result,
                 const ComparisonSettings& settings) {
  Json json = comparisonJson(result.comparison);
  json["seconds_a"] = result.a.bestSeconds();
  json["seconds_b"] = result.b.bestSeconds();
  addEnding(json, result.comparison);
  json["arms"] = {{"a", outcomeJson(result.a)}, {"b", outcomeJson(result.b)}};
  Json provenance = machineJson();
  provenance["scene"] = scene.path;
  provenance["settings"] = settingsJson(settings);
  provenance["a"] = armJson(a);
  provenance["b"] = armJson(b);
  json["provenance"] = provenance;
  return json;
}

Json compareJson(const PictureFiles& files, const Comparison& comparison,
                 const ComparisonSettings& settings) {
  Json json = comparisonJson(comparison);
  json["seconds_a"] = nullptr;
  json["seconds_b"] = nullptr;
  addEnding(json, comparison);
  Json provenance = machineJson();
  provenance["settings"] = settingsJson(settings);
  provenance["a"] = {{"file", files.a},
                     {"standard_error", files.standardErrorA},
                     {"metadata", comparison.a.metadata}};
  provenance["b"] = {{"file", files.b},
                     {"standard_error", files.standardErrorB},
                     {"metadata", comparison.b.metadata}};
  json["provenance"] = provenance;
  return json;
}

std::string jsonText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace twintrace
