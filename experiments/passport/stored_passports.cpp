#include "experiments/passport/stored_passports.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>

#include "common/scene/option_names.h"
#include "experiments/passport/passport_json.h"

namespace twintrace {
namespace {

std::string glOf(const RenderOptions& options) { return findOption("gl")->get(options); }

}  // namespace

Json armPassports(const Arm& a, const Arm& b) {
  Json passports = Json::object();
  for (const auto& [name, arm] : {std::pair{"a", &a}, std::pair{"b", &b}}) {
    if (arm->options.backend != BackEnd::gpu) continue;
    passports[name] = deviceJson(devicePassport(arm->options));
  }
  return passports;
}

std::vector<std::string> passportWarnings(const std::string& path, const Json& passports) {
  std::ifstream stream(path);
  const Json stored = Json::parse(stream, nullptr, false);
  std::vector<std::string> warnings;
  if (!stored.is_object()) return warnings;
  for (const auto& [name, passport] : passports.items()) {
    const auto before = stored.find(name);
    if (before == stored.end() || !before->is_object()) continue;
    const auto changed = changedFacts(factsOf(*before), factsOf(passport));
    if (changed.empty()) continue;
    warnings.push_back(
        fmt::format("the GL of arm {} is not the one whose results {} belongs to: it differs in {}",
                    name, path, fmt::join(changed, ", ")));
  }
  return warnings;
}

std::string strictWarning(const Arm& arm) {
  const RenderOptions& options = arm.options;
  if (options.backend != BackEnd::gpu || options.maths != Maths::strict) return "";
  for (const auto& [name, value] : arm.renderer->provenance()) {
    if (name != "strict" || !value.starts_with("no")) continue;
    return fmt::format("strict maths is not strict on this GL: {}; see twintrace info --passport --gl {}",
                       value.substr(std::string_view("no: ").size()), glOf(options));
  }
  return "";
}

}  // namespace twintrace
