#include "experiments/passport/passport_text.h"

#include <fmt/format.h>

#include <bit>

namespace twintrace {
namespace {

/// Facts that are hashes say nothing to people.
constexpr std::string_view kHashed = "bits of ";

std::string factText(const PassportFact& fact) {
  return fmt::format("{:<34}{}{}\n", fact.name, fact.value,
                     fact.breaksStrict ? "  <- breaks strict maths" : "");
}

std::string worstText(const BuiltinAccuracy& builtin) {
  std::string text;
  for (const std::uint32_t word : builtin.inputs) {
    if (word == 0) continue;
    if (!text.empty()) text += ' ';
    text += fmt::format("{:a}", std::bit_cast<float>(word));
  }
  return text;
}

std::string accuracyText(const BuiltinAccuracy& builtin) {
  const char* verdict = !builtin.hasBound ? "" : builtin.withinBound ? "; within" : "; BEYOND";
  return fmt::format("{:<16}{:>11.4g} {:>10.2g}  {}{}; worst at {}\n", builtin.name, builtin.maxUlp,
                     builtin.maxAbsolute, builtin.allowance, verdict, worstText(builtin));
}

}  // namespace

std::string passportText(const Passport& passport) {
  const DevicePassport& device = passport.device;
  std::string text = fmt::format("{}, OpenGL {}, {}\n\n", device.renderer, device.version,
                                 passport.source);
  for (const PassportFact& fact : device.facts) {
    if (!std::string_view(fact.name).starts_with(kHashed)) text += factText(fact);
  }
  for (const PassportFact& fact : passport.fragment) text += factText(fact);
  text += fmt::format("\n{:<16}{:>11} {:>10}  {}\n", "builtin", "max ulp", "max error",
                      "allowance of GLSL 4.60, 4.7.1");
  for (const BuiltinAccuracy& builtin : passport.builtins) text += accuracyText(builtin);
  return text + fmt::format("\ndigest: {}\nstrict: {}\n", device.digest(), device.strictness());
}

}  // namespace twintrace
