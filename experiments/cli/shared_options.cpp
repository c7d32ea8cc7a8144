#include "experiments/cli/shared_options.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/film/exact_sum.h"
#include "common/scene/option_names.h"
#include "experiments/shader_override.h"

namespace twintrace {
namespace {

constexpr int kMaxSpp = 1 << 30;  // of option spp

void checkShaderDirectory(const std::string& directory) {
  std::error_code error;
  if (directory.empty() || std::filesystem::is_directory(directory, error)) return;
  throw UsageError("shader-dir: found " + quote(directory) + ", expected a directory");
}

/// An arm's list without its overrides, and these.
struct ArmList {
  std::string settings;
  std::vector<std::string> overrides;
};

/// Overrides hold a second `=`, so they are taken out before the list is read as `name=value`.
ArmList splitArmList(const std::string& list) {
  constexpr std::string_view kKey = "override=";
  if (("," + list).find("," + std::string(kKey)) == std::string::npos) return {list, {}};
  ArmList found;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ',');) {
    if (part.starts_with(kKey)) {
      found.overrides.push_back(part.substr(kKey.size()));
    } else {
      found.settings += (found.settings.empty() ? "" : ",") + part;
    }
  }
  return found;
}

}  // namespace

bool GivenOptions::has(std::string_view name) const {
  const bool alone = std::any_of(list.begin(), list.end(),
                                 [name](const auto& option) { return option.first == name; });
  return alone || ("," + armList).find("," + std::string(name) + "=") != std::string::npos;
}

void addRenderOptions(CommandSyntax& syntax, GivenOptions& given) {
  for (const Option& option : renderOptionTable()) {
    const auto store = [&given, name = option.name](const std::string& value) {
      given.list.emplace_back(name, value);
    };
    syntax.callback("--" + option.name, store, option.expected).group("Rendering").takeLast();
  }
  addShaderOptions(syntax, given);
}

void addShaderOptions(CommandSyntax& syntax, GivenOptions& given) {
  syntax
      .option("--shader-dir", given.shaderDirectory,
              "read the shaders from this directory, not from the program")
      .group("Rendering");
  syntax
      .option("--override", given.overrides,
              "put a file in the place of a shader on the GPU; may be given several times")
      .typeName("shaders/X.glsl=FILE")
      .repeatable()
      .group("Rendering");
}

void addAnswerOptions(CommandSyntax& syntax, AnswerOptions& options) {
  syntax.option("--json", options.json, "write the result as JSON, - for standard output");
  syntax.flag("--quiet", options.quiet, "neither progress nor summary");
}

RenderOptions layOptions(RenderOptions options, const GivenOptions& given) {
  for (const auto& [name, value] : given.list) setOption(options, name, value);
  const auto [settings, ownOverrides] = splitArmList(given.armList);
  setOptions(options, settings);
  checkShaderDirectory(given.shaderDirectory);
  options.shaderDirectory = given.shaderDirectory;
  for (const auto& overrides : {given.overrides, ownOverrides}) {
    for (const std::string& assignment : overrides) {
      options.shaderOverrides.push_back(readShaderOverride(assignment, given.shaderDirectory));
    }
  }
  return options;
}

bool stopRuleDecides(const RenderOptions& options, const GivenOptions& given) {
  const bool ruleGiven = (given.has("time") && options.timeLimit > 0) ||
                         (given.has("target-error") && options.targetError > 0);
  return ruleGiven && !given.has("spp");
}

void liftSampleLimit(RenderOptions& options) {
  const std::int64_t most = std::int64_t{kMaxFrames} * options.passes;
  options.spp = static_cast<int>(std::min<std::int64_t>(most, kMaxSpp));
}

RenderOptions applyOptions(const RenderOptions& ofScene, const GivenOptions& given) {
  RenderOptions options = layOptions(ofScene, given);
  if (stopRuleDecides(options, given)) liftSampleLimit(options);
  return options;
}

}  // namespace twintrace
