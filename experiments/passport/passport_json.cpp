#include "experiments/passport/passport_json.h"

#include <fmt/format.h>

#include <bit>

namespace twintrace {
namespace {

Json accuracyJson(const BuiltinAccuracy& builtin) {
  Json worst = Json::array();
  for (const std::uint32_t word : builtin.inputs) {
    worst.push_back(fmt::format("{:a}", std::bit_cast<float>(word)));
  }
  return {{"name", builtin.name},
          {"max_ulp", builtin.maxUlp},
          {"max_absolute", builtin.maxAbsolute},
          {"worst_inputs", worst},
          {"worst_value", fmt::format("{:a}", std::bit_cast<float>(builtin.found))},
          {"worst_exact", builtin.exact},
          {"allowance", builtin.allowance},
          {"within_allowance", builtin.hasBound ? Json(builtin.withinBound) : Json(nullptr)}};
}

}  // namespace

Json deviceJson(const DevicePassport& passport) {
  Json facts = Json::object();
  for (const PassportFact& fact : passport.facts) facts[fact.name] = fact.value;
  return {{"renderer", passport.renderer},
          {"version", passport.version},
          {"digest", passport.digest()},
          {"strict", passport.strictness()},
          {"facts", facts}};
}

Json passportJson(const Passport& passport) {
  Json json = deviceJson(passport.device);
  json["source"] = passport.source;
  for (const PassportFact& fact : passport.fragment) json["fragment"][fact.name] = fact.value;
  json["builtins"] = Json::array();
  for (const BuiltinAccuracy& builtin : passport.builtins) {
    json["builtins"].push_back(accuracyJson(builtin));
  }
  return json;
}

std::vector<PassportFact> factsOf(const Json& device) {
  std::vector<PassportFact> facts;
  const auto found = device.find("facts");
  if (found == device.end() || !found->is_object()) return facts;
  for (const auto& [name, value] : found->items()) {
    if (value.is_string()) facts.push_back({name, value.get<std::string>(), false});
  }
  return facts;
}

}  // namespace twintrace
