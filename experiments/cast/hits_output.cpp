#include "experiments/cast/hits_output.h"

#include "common/cast/case_csv.h"
#include "common/cast/rays_csv.h"

namespace twintrace {
namespace {

struct Answer {
  std::int32_t primitive = -1;
  double t = 0.0;
  glm::dvec3 normal{0.0};
  std::optional<Clarity> clarity;
};

Answer answerOf(const CastHit& hit) {
  if (!hit.valid()) return {};
  return {hit.primitive, hit.t, glm::dvec3(hit.normal), std::nullopt};
}

Answer answerOf(const ExactHit& hit) {
  return {hit.primitive, hit.t, hit.normal, hit.clarity};
}

void writeLine(std::ostream& out, HitsFormat format, const CaseSet& cases, std::size_t ray,
               const std::string& engine, const Answer& answer) {
  if (format == HitsFormat::cases) {
    const CaseAnswer line{answer.primitive, answer.t, answer.normal, answer.clarity};
    return writeCaseHit(out, cases, ray, engine, line);
  }
  const bool hit = answer.primitive >= 0;
  const std::string object =
      hit ? primitiveName(cases, cases.rays[ray], answer.primitive) : std::string();
  writeRayHit(out, ray, engine, {object, answer.primitive, answer.t, answer.normal});
}

}  // namespace

HitsOutput::HitsOutput(std::ostream& out, HitsFormat format) : out_(out), format_(format) {
  if (format == HitsFormat::rays) {
    writeRayHitsHeader(out);
  } else {
    writeCaseHitsHeader(out);
  }
}

void HitsOutput::write(const CaseSet& cases, const std::string& engine,
                       const std::vector<CastHit>& answers) {
  for (std::size_t ray = 0; ray < answers.size(); ++ray) {
    writeLine(out_, format_, cases, ray, engine, answerOf(answers[ray]));
  }
}

void HitsOutput::write(const CaseSet& cases, const std::vector<ExactHit>& exact) {
  for (std::size_t ray = 0; ray < exact.size(); ++ray) {
    writeLine(out_, format_, cases, ray, "exact", answerOf(exact[ray]));
  }
}

void HitsOutput::write(const JuryReport& report) {
  const CaseSet cases = casesOf(report.disagreements);
  for (std::size_t ray = 0; ray < report.disagreements.size(); ++ray) {
    const Disagreement& kept = report.disagreements[ray];
    if (kept.exact) writeLine(out_, format_, cases, ray, "exact", answerOf(*kept.exact));
    for (std::size_t engine = 0; engine < kept.answers.size(); ++engine) {
      if (report.engines[engine].tally.all().rays == 0) continue;
      Answer answer = answerOf(kept.answers[engine]);
      if (kept.exact) answer.clarity = kept.exact->clarity;
      writeLine(out_, format_, cases, ray, report.engines[engine].label, answer);
    }
  }
}

}  // namespace twintrace
