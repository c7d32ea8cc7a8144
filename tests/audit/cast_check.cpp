#include "tests/audit/cast_check.h"

#include <algorithm>
#include <stdexcept>

#include "experiments/cast/jury_engines.h"

namespace twintrace::test {
namespace {

constexpr std::uint32_t kRays = 1000;  // per family
constexpr std::uint64_t kSeed = 1;
constexpr const char* kMain = "main of mains/cast_fragment.glsl";

std::vector<JuryEngine> openEngines(Intersector intersector,
                                    const std::vector<ShaderReplacement>& shaders) {
  RenderOptions options;
  options.intersector = intersector;
  options.intersectorGiven = true;
  options.shaderOverrides = shaders;
  const bool robust = intersector == Intersector::robust;
  std::vector<JuryEngine> engines;
  for (const char* name : {"gpu", "cpu"}) {
    const std::string label = std::string(name) + (robust ? "" : "/report");
    engines.push_back({label, robust, false, openCaseEngine(name, options)});
  }
  return engines;
}

}  // namespace

CastCheck::CastCheck(const std::vector<std::string>& families, const ShaderTexts& texts)
    : reached_(texts.reachableFrom(kMain)) {
  for (const std::string& name : families) {
    dockets_.push_back({findFamily(name), drawFamily(name, kRays, kSeed)});
  }
}

Finding CastCheck::find(const Damage& damage) {
  const auto isReached = [&](const FunctionText& f) { return reached_.contains(f.name); };
  if (std::ranges::none_of(damage.functions, isReached)) return {};
  const Finding finding = hear({damage.shader});
  if (finding.answer == Answer::yes) requireSound();
  return finding;
}

void CastCheck::requireSound() {
  if (sound_) return;
  const Finding finding = hear({});
  if (finding.answer == Answer::yes) {
    throw std::logic_error("cast finds a mistake without a fault: " + finding.detail);
  }
  sound_ = true;
}

Finding CastCheck::hear(const std::vector<ShaderReplacement>& shaders) const {
  for (const Intersector intersector : {Intersector::robust, Intersector::report}) {
    const Finding finding = hear(intersector, shaders);
    if (finding.answer == Answer::yes) return finding;
  }
  return {Answer::no, ""};
}

Finding CastCheck::hear(Intersector intersector,
                        const std::vector<ShaderReplacement>& shaders) const {
  std::vector<JuryEngine> engines = openEngines(intersector, shaders);
  Jury jury(engines, 0);
  for (const Docket& docket : dockets_) {
    JuryReport report = jury.open(docket.family.name, docket.family.what);
    jury.hear(report, docket.cases, docket.family.expectation);
    if (!report.failed()) continue;
    const Tally& tally = report.engines.front().tally;
    const char* which = intersector == Intersector::robust ? "" : "intersector report, ";
    return {Answer::yes, which + docket.family.name + ", " + std::to_string(report.twinsDiffer) +
                             " rays unlike the twin's, " + std::to_string(tally.inexcusable()) +
                             " wrong"};
  }
  return {Answer::no, ""};
}

}  // namespace twintrace::test
