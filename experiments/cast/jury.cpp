#include "experiments/cast/jury.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/cast/case_csv.h"
#include "cpu/exact/arbiter.h"

namespace twintrace {
namespace {

bool hasNan(const CastRay& ray) {
  const auto anyNan = [](const glm::vec3& v) {
    return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z);
  };
  return anyNan(ray.origin) || anyNan(ray.direction) || std::isnan(ray.tmin) ||
         std::isnan(ray.tmax);
}

/// Which scenes an engine has all primitives of.
std::vector<bool> scenesOf(const CaseEngine& engine, const CaseSet& cases) {
  std::vector<bool> answerable;
  for (const CaseScene& scene : cases.scenes) {
    const auto first = cases.primitives.begin() + scene.first;
    answerable.push_back(std::all_of(first, first + scene.count,
                                     [&](const CasePrimitive& p) { return engine.has(p.kind); }));
  }
  return answerable;
}

void countExact(JuryReport& report, const ExactHit& exact) {
  report.hits += exact.primitive >= 0;
  report.clean += exact.clarity == Clarity::clean;
  report.ambiguous += exact.clarity == Clarity::ambiguous;
  report.ties += exact.clarity == Clarity::tie;
}

/// One hearing: all answers to one set of cases.
class Hearing {
 public:
  Hearing(std::vector<JuryEngine>& engines, const CaseSet& cases, Expectation expectation)
      : engines_(engines), cases_(cases), expectation_(expectation) {
    const bool bounces = !cases.bounces.empty();
    if (!bounces) exact_ = arbitrate(cases);
    for (JuryEngine& engine : engines) {
      const bool asked = !bounces || engine.engine->canBounce();
      answers_.push_back(asked ? engine.engine->cast(cases) : std::vector<CastHit>{});
      const std::size_t sceneCount = cases.scenes.size();
      answerable_.push_back(asked ? scenesOf(*engine.engine, cases)
                                  : std::vector<bool>(sceneCount, false));
    }
  }

  void addTo(JuryReport& report, std::size_t keep, std::uint64_t firstRay) const {
    for (std::size_t ray = 0; ray < cases_.rays.size(); ++ray) {
      addRay(report, ray, keep, firstRay + ray);
    }
  }

 private:
  bool wasAsked(std::size_t engine, std::size_t ray) const {
    return answerable_[engine][cases_.rays[ray].scene];
  }

  Judgement judge(std::size_t engine, std::size_t ray) const {
    const CastHit& answer = answers_[engine][ray];
    if (exact_.empty()) return judgeBounce(answer, cases_.rays[ray].ray, expectation_);
    const auto primitiveCount = static_cast<int>(cases_.primitivesOf(cases_.rays[ray]).size());
    return judgeHit(exact_[ray], answer, primitiveCount, expectation_ == Expectation::closed);
  }

  void addRay(JuryReport& report, std::size_t ray, std::size_t keep, std::uint64_t number) const {
    ++report.rays;
    report.unanswerable += hasNan(cases_.rays[ray].ray);
    if (!exact_.empty()) countExact(report, exact_[ray]);
    std::vector<Judgement> judgements(engines_.size());
    bool kept = addTwins(report, ray);
    for (std::size_t engine = 0; engine < engines_.size(); ++engine) {
      if (!wasAsked(engine, ray)) continue;
      judgements[engine] = judge(engine, ray);
      report.engines[engine].tally.add(judgements[engine]);
      const Finding finding = judgements[engine].finding;
      const bool wrong = finding != Finding::agrees && finding != Finding::notStarted;
      kept = kept || (wrong && engines_[engine].listed);
    }
    if (kept && report.disagreements.size() < keep) {
      report.disagreements.push_back(disagreement(report.name, ray, number, std::move(judgements)));
    }
  }

  /// Compares gpu with cpu, each with the same intersector. @return whether they differ
  bool addTwins(JuryReport& report, std::size_t ray) const {
    bool compared = false;
    bool differ = false;
    for (const std::string intersector : {"", "/report"}) {
      const int gpu = indexOf("gpu" + intersector);
      const int cpu = indexOf("cpu" + intersector);
      if (gpu < 0 || cpu < 0) continue;
      compared = true;
      differ =
          differ || !sameAnswer(answers_[std::size_t(gpu)][ray], answers_[std::size_t(cpu)][ray]);
    }
    report.twinsCompared += compared;
    report.twinsDiffer += differ;
    return differ;
  }

  int indexOf(const std::string& label) const {
    for (std::size_t i = 0; i < engines_.size(); ++i) {
      if (engines_[i].label == label) return static_cast<int>(i);
    }
    return -1;
  }

  Disagreement disagreement(const std::string& report, std::size_t ray, std::uint64_t number,
                            std::vector<Judgement> judgements) const {
    const CaseRay& caseRay = cases_.rays[ray];
    const auto primitives = cases_.primitivesOf(caseRay);
    Disagreement kept;
    const bool named = !cases_.rayNames.empty() || !cases_.sceneNames.empty();
    kept.scene = named ? sceneName(cases_, caseRay.scene) : fmt::format("{}-{}", report, number);
    kept.ray = named ? rayName(cases_, ray) : std::to_string(number);
    kept.primitives.assign(primitives.begin(), primitives.end());
    for (int i = 0; i < static_cast<int>(primitives.size()); ++i) {
      kept.primitiveNames.push_back(primitiveName(cases_, caseRay, i));
    }
    kept.cast = caseRay.ray;
    if (!exact_.empty()) kept.exact = exact_[ray];
    for (std::size_t engine = 0; engine < engines_.size(); ++engine) {
      kept.answers.push_back(wasAsked(engine, ray) ? answers_[engine][ray] : CastHit{});
    }
    kept.judgements = std::move(judgements);
    return kept;
  }

  std::vector<JuryEngine>& engines_;
  const CaseSet& cases_;
  Expectation expectation_;
  std::vector<ExactHit> exact_;  ///< none for bounces
  std::vector<std::vector<CastHit>> answers_;
  std::vector<std::vector<bool>> answerable_;
};

}  // namespace

bool JuryReport::failed() const {
  if (twinsDiffer > 0) return true;
  return std::any_of(engines.begin(), engines.end(), [](const EngineVerdict& engine) {
    return engine.trusted && engine.tally.inexcusable() > 0;
  });
}

JuryReport Jury::open(const std::string& name, const std::string& what) const {
  JuryReport report;
  report.name = name;
  report.what = what;
  for (const JuryEngine& engine : engines_) {
    report.engines.push_back({engine.label, engine.trusted, {}});
  }
  return report;
}

void Jury::hear(JuryReport& report, const CaseSet& cases, Expectation expectation,
                std::uint64_t firstRay) {
  report.bounces = !cases.bounces.empty();
  Hearing(engines_, cases, expectation).addTo(report, keep_, firstRay);
}

CastHit asAnswer(const ExactHit& exact) {
  CastHit hit;
  if (exact.primitive < 0) return hit;
  hit.primitive = exact.primitive;
  hit.t = static_cast<float>(exact.t);
  hit.normal = glm::vec3(exact.normal);
  return hit;
}

CaseSet casesOf(const std::vector<Disagreement>& disagreements) {
  CaseSet cases;
  for (const Disagreement& kept : disagreements) {
    // Rays of one scene follow each other.
    if (cases.sceneNames.empty() || cases.sceneNames.back() != kept.scene) {
      cases.scenes.push_back({static_cast<std::uint32_t>(cases.primitives.size()),
                              static_cast<std::uint32_t>(kept.primitives.size())});
      cases.sceneNames.push_back(kept.scene);
      cases.primitives.insert(cases.primitives.end(), kept.primitives.begin(),
                              kept.primitives.end());
      cases.primitiveNames.insert(cases.primitiveNames.end(), kept.primitiveNames.begin(),
                                  kept.primitiveNames.end());
    }
    cases.rays.push_back({kept.cast, static_cast<std::uint32_t>(cases.scenes.size() - 1)});
    cases.rayNames.push_back(kept.ray);
  }
  return cases;
}

}  // namespace twintrace
