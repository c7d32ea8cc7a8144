#include "common/scene/read_settings.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "common/base/wording.h"
#include "common/scene/effects.h"
#include "common/scene/option_names.h"

namespace twintrace {

namespace {

/// Sine of the angle between `up` and the view below which they count as parallel: 16 times the
/// rounding unit of a float, where the cross product's direction is all rounding error.
constexpr double kParallelSine = 16.0 / (1 << 24);

bool belongsToFilm(const Option& option) {
  return option.name == "width" || option.name == "height";
}

std::optional<OptionValue> optionValue(OptionType type, const toml::node& node) {
  if (type == OptionType::integer && node.is_integer()) return node.as_integer()->get();
  if (type == OptionType::number && node.is_number()) return node.value<double>().value_or(0.0);
  if (type == OptionType::text && node.is_string()) return node.as_string()->get();
  return std::nullopt;
}

std::string optionSuggestion(const Option& option, const toml::node& node) {
  return node.is_string() ? didYouMean(node.as_string()->get(), option.choices) : "";
}

void readOption(TableReader& table, const Option& option, RenderOptions& options) {
  const toml::node* node = table.find(option.name, option.expected, Need::optional);
  if (node == nullptr) return;
  const std::optional<OptionValue> value = optionValue(option.type, *node);
  if (value && option.set(options, *value)) return;
  table.faults().add(node->source().begin, describe(*node),
                     option.expected + optionSuggestion(option, *node));
}

void readOptions(TableReader& table, bool film, RenderOptions& options) {
  for (const Option& option : renderOptionTable()) {
    if (belongsToFilm(option) == film) readOption(table, option, options);
  }
  table.finish();
}

void checkOrientation(TableReader& table, const Camera& camera) {
  const glm::dvec3 view = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
  const double viewLength = glm::length(view);
  if (viewLength < kMinLength) {
    table.faults().add(table.positionOf("target"), "a target equal to eye",
                       "a target that is not eye (at least 1e-18 away)");
    return;
  }
  const glm::dvec3 up(camera.up);
  const double sine = glm::length(glm::cross(view / viewLength, up / glm::length(up)));
  if (sine >= kParallelSine) return;
  const std::string_view key = table.has("up") ? "up" : "target";
  table.faults().add(table.positionOf(key), "up parallel to the view (from eye to target)",
                     "an up that is not parallel to it");
}

void checkFocalPlane(TableReader& table, const RenderOptions& options, const Camera& camera) {
  const double distance = glm::length(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
  const double focus = camera.focus ? *camera.focus : distance;
  const double height = 2 * focus * std::tan(camera.fov * std::numbers::pi / 360);
  const double width = height * options.width / options.height;
  if (height <= kMaxMagnitude && width <= kMaxMagnitude) return;
  table.faults().add(
      table.positionOf("fov"),
      fmt::format("a picture {:.3g} by {:.3g} units large at the focus distance", width, height),
      "at most 1e18 (a smaller fov, a nearer target or focus)");
}

void checkImage(TableReader& table, const FileCheck& check, const std::string& image,
                const std::string& resolved) {
  if (table.has("radiance")) {
    table.faults().add(table.keyPositionOf("image"), "both 'radiance' and 'image'",
                       "only one of them");
  }
  if (!check(resolved)) {
    table.faults().add(table.positionOf("image"), "no file " + quote(image),
                       "a readable image file");
  }
}

void rejectWithoutImage(TableReader& table, std::string_view key) {
  if (!table.has(key) || table.has("image")) return;
  table.faults().add(table.keyPositionOf(key), quote(key) + " without 'image'",
                     "it only beside 'image'");
}

}  // namespace

void readFilmAndRender(TableReader& document, RenderOptions& options) {
  Faults& faults = document.faults();
  const toml::source_position film = document.keyPositionOf("film");
  const toml::source_position render = document.keyPositionOf("render");
  if (const toml::table* content = document.readTable("film")) {
    TableReader table(*content, film, faults);
    readOptions(table, true, options);
  }
  if (const toml::table* content = document.readTable("render")) {
    TableReader table(*content, render, faults);
    readOptions(table, false, options);
  }
  if (const auto conflict = filmConflict(options)) faults.add(film, *conflict);
  if (const auto conflict = sampleConflict(options)) faults.add(render, *conflict);
}

void readCamera(TableReader& document, const RenderOptions& options, Camera& camera) {
  const toml::table* content = document.readTable("camera");
  if (content == nullptr) return;
  TableReader table(*content, document.keyPositionOf("camera"), document.faults());
  const auto wellFormed = [&](std::string_view key, bool set) { return set || !table.has(key); };
  bool right = wellFormed("eye", table.read("eye", camera.eye, kAnyNumber));
  right = wellFormed("target", table.read("target", camera.target, kAnyNumber)) && right;
  right = wellFormed("up", table.readDirection("up", camera.up)) && right;
  right = wellFormed("fov", table.read("fov", camera.fov, kFieldOfView)) && right;
  table.read("aperture", camera.aperture, kNotNegative);
  float focus = 0;
  if (table.read("focus", focus, kPositiveLength)) camera.focus = focus;
  table.finish();
  if (!right) return;
  checkOrientation(table, camera);
  checkFocalPlane(table, options, camera);
}

void readEnvironment(TableReader& document, const std::string& scenePath, const FileCheck& check,
                     Environment& environment) {
  const toml::table* content = document.readTable("environment");
  if (content == nullptr) return;
  TableReader table(*content, document.keyPositionOf("environment"), document.faults());
  table.read("radiance", environment.radiance, kNotNegative);
  std::string image;
  if (table.read("image", image, "the name of an image file")) {
    environment.image = (std::filesystem::path(scenePath).parent_path() / image).string();
    checkImage(table, check, image, environment.image);
  }
  table.read("strength", environment.strength, kNotNegative);
  table.read("rotation", environment.rotation, kAnyNumber);
  rejectWithoutImage(table, "strength");
  rejectWithoutImage(table, "rotation");
  table.finish();
}

void readEffects(TableReader& document, std::map<std::string, bool>& forcedEffects) {
  const toml::table* content = document.readTable("effects");
  if (content == nullptr) return;
  TableReader table(*content, document.keyPositionOf("effects"), document.faults());
  for (const std::string_view name : kEffectNames) {
    bool on = false;
    if (table.read(name, on)) forcedEffects[std::string(name)] = on;
  }
  table.finish();
}

}  // namespace twintrace
