#include "experiments/cast/jury_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/cast/case_csv.h"
#include "common/cast/csv_rows.h"

namespace twintrace {
namespace {

/// Short enough for its column, and never `0` for what isn't.
std::string errorText(double value) {
  if (value == 0) return "0";
  if (value < 0.01) return "<.01";
  if (value < 100) return fmt::format("{:.2f}", value);
  if (value < 1e6) return fmt::format("{:.0f}", value);
  return fmt::format("{:.0e}", value);
}

std::string shareText(std::uint64_t part, std::uint64_t whole) {
  if (part == 0) return "0";
  const double percent = 100.0 * double(part) / double(whole);
  if (percent < 0.01) return "<.01%";
  return percent < 9.995 ? fmt::format("{:.2f}%", percent) : fmt::format("{:.0f}%", percent);
}

std::string hitLine(const char* name, const char* which, const Counts& counts,
                    const std::string& notNumbers, const Spread& distance, const Spread& ulp) {
  return fmt::format("{:<11} {:<5} {:>7} {:>7} {:>7} {:>7} {:>7} {:>5} {:>8} {:>8} {:>8} {:>8}\n",
                     name, which, counts.falseMisses, counts.falseHits, counts.wrongPrimitives,
                     counts.wrongDistances, counts.wrongNormals, notNumbers,
                     errorText(distance.usual), errorText(distance.most), errorText(ulp.usual),
                     errorText(ulp.most));
}

std::string hitTable(const JuryReport& report) {
  std::string text =
      "                    false   false   wrong   wrong   wrong         distance error K"
      "         ulp of t\n"
      "engine      rays   misses    hits   prim.    dist.  normal   NaN   99.9 %      max"
      "   99.9 %      max\n";
  for (const EngineVerdict& engine : report.engines) {
    const Tally& tally = engine.tally;
    if (tally.all().rays == 0) {
      text += fmt::format("{:<11} has not all of these primitives\n", engine.label);
      continue;
    }
    text += hitLine(engine.label.c_str(), "all", tally.all(), std::to_string(tally.notNumbers()),
                    tally.distanceErrors(false), tally.ulps(false));
    text += hitLine("", "clean", tally.clean(), "", tally.distanceErrors(true), tally.ulps(true));
  }
  return text;
}

std::string bounceTable(const JuryReport& report) {
  std::string text = "engine         bounces  self-hits     leaks       NaN\n";
  for (const EngineVerdict& engine : report.engines) {
    const Tally& tally = engine.tally;
    if (tally.all().rays == 0) continue;
    text += fmt::format("{:<11} {:>10} {:>10} {:>9} {:>9}\n", engine.label,
                        tally.all().rays - tally.notStarted(), tally.all().selfHits,
                        tally.all().leaks, tally.notNumbers());
  }
  return text;
}

std::string headline(const JuryReport& report) {
  const char* separator = report.what.empty() ? "" : ": ";
  std::string text = fmt::format("{}{}{}\n", report.name, separator, report.what);
  if (report.bounces) return text + fmt::format("{} rays that bounce once\n", report.rays);
  return text +
         fmt::format("{} rays: {} clean, {} ambiguous, {} ties; {} hit in exact arithmetic\n",
                     report.rays, report.clean, report.ambiguous, report.ties, report.hits);
}

std::string twinsText(const JuryReport& report) {
  if (report.twinsCompared == 0) return "";
  return fmt::format("gpu and cpu differ on {} of {} rays\n", report.twinsDiffer,
                     report.twinsCompared);
}

std::string countText(std::uint64_t count) {
  return count < 10000 ? std::to_string(count) : fmt::format("{:.0e}", double(count));
}

/// `inexcusable share`, in 11 columns.
std::string cell(const EngineVerdict& engine) {
  const Tally& tally = engine.tally;
  const std::uint64_t asked = tally.all().rays - tally.notStarted();
  if (asked == 0) return fmt::format(" {:>10}", "-");
  const std::uint64_t wrong = tally.all().wrongAnswers() + tally.notNumbers();
  return fmt::format(" {:>4} {:>5}", countText(tally.inexcusable()), shareText(wrong, asked));
}

std::string vectorText(const glm::vec3& v) {
  return fmt::format("{},{},{}", hexFloat(v.x), hexFloat(v.y), hexFloat(v.z));
}

std::string primitiveText(const CasePrimitive& primitive) {
  constexpr const char* kNames[] = {"sphere", "box", "obb", "plane", "tri"};
  std::string text = fmt::format("  {}", kNames[static_cast<int>(primitive.kind)]);
  for (int i = 0; i < valueCount(primitive.kind); ++i) {
    text += i == 0 ? ' ' : ',';
    text += hexFloat(primitive.values[static_cast<std::size_t>(i)]);
  }
  return text + "\n";
}

std::string answerText(const char* label, const CastHit& hit, const char* finding) {
  if (!hit.valid()) return fmt::format("  {:<10} miss {}\n", label, finding);
  return fmt::format("  {:<10} primitive {} t {} normal {} {}\n", label, hit.primitive,
                     hexFloat(hit.t), vectorText(hit.normal), finding);
}

/// Scenes of more primitives are left to files.
constexpr std::size_t kPrimitivesShown = 8;

std::string disagreementText(const JuryReport& report, const Disagreement& kept) {
  std::string text = fmt::format("scene {} ray {}\n", kept.scene, kept.ray);
  const std::size_t shown = std::min(kept.primitives.size(), kPrimitivesShown);
  for (std::size_t i = 0; i < shown; ++i) text += primitiveText(kept.primitives[i]);
  if (shown < kept.primitives.size()) {
    text += fmt::format("  and {} more primitives\n", kept.primitives.size() - shown);
  }
  text += fmt::format("  ray {},{},{},{}\n", vectorText(kept.cast.origin),
                      vectorText(kept.cast.direction), hexFloat(kept.cast.tmin),
                      hexFloat(kept.cast.tmax));
  if (kept.exact) {
    text += answerText("exact", asAnswer(*kept.exact),
                       std::string(clarityName(kept.exact->clarity)).c_str());
  }
  for (std::size_t i = 0; i < kept.answers.size(); ++i) {
    if (report.engines[i].tally.all().rays == 0) continue;
    text += answerText(report.engines[i].label.c_str(), kept.answers[i],
                       findingName(kept.judgements[i].finding));
  }
  return text;
}

Json countsJson(const Counts& counts, const Spread& distance, const Spread& ulp) {
  return {{"rays", counts.rays},
          {"false_misses", counts.falseMisses},
          {"false_hits", counts.falseHits},
          {"wrong_primitives", counts.wrongPrimitives},
          {"wrong_distances", counts.wrongDistances},
          {"wrong_normals", counts.wrongNormals},
          {"distance_error_999", distance.usual},
          {"distance_error_max", distance.most},
          {"ulp_999", ulp.usual},
          {"ulp_max", ulp.most}};
}

Json engineJson(const EngineVerdict& engine, bool bounces) {
  const Tally& tally = engine.tally;
  Json json = {{"engine", engine.label},
               {"trusted", engine.trusted},
               {"asked", tally.all().rays - tally.notStarted()},
               {"nan", tally.notNumbers()},
               {"inexcusable", tally.inexcusable()}};
  if (bounces) {
    json["self_hits"] = tally.all().selfHits;
    json["leaks"] = tally.all().leaks;
    return json;
  }
  json["all"] = countsJson(tally.all(), tally.distanceErrors(false), tally.ulps(false));
  json["clean"] = countsJson(tally.clean(), tally.distanceErrors(true), tally.ulps(true));
  return json;
}

}  // namespace

std::string reportText(const JuryReport& report) {
  return headline(report) + (report.bounces ? bounceTable(report) : hitTable(report)) +
         twinsText(report);
}

std::string summaryText(const std::vector<JuryReport>& reports) {
  if (reports.empty()) return "";
  std::string text =
      "per engine: wrong answers that nothing excuses (on clean rays), share of wrong answers\n" +
      fmt::format("{:<25}{:>6}", "family", "clean");
  for (const EngineVerdict& engine : reports.front().engines) {
    text += fmt::format(" {:>10}", engine.label);
  }
  text += "\n";
  for (const JuryReport& report : reports) {
    const std::string clean = report.bounces ? "-" : shareText(report.clean, report.rays);
    text += fmt::format("{:<25}{:>6}", report.name, clean);
    for (const EngineVerdict& engine : report.engines) text += cell(engine);
    text += report.failed() ? " *\n" : "\n";
  }
  return text;
}

std::string juryVerdictText(const std::vector<JuryReport>& reports) {
  std::string failed;
  std::uint64_t rays = 0;
  for (const JuryReport& report : reports) {
    rays += report.rays;
    if (!report.failed()) continue;
    failed += fmt::format("  {}:", report.name);
    for (const EngineVerdict& engine : report.engines) {
      if (!engine.trusted || engine.tally.inexcusable() == 0) continue;
      failed += fmt::format(" {} is wrong on {}", engine.label, engine.tally.inexcusable());
    }
    if (report.twinsDiffer > 0)
      failed += fmt::format(" gpu and cpu differ on {}", report.twinsDiffer);
    failed += "\n";
  }
  if (!failed.empty()) return "verdict: different\n" + failed;
  return fmt::format("verdict: no wrong answer that nothing excuses on {} rays\n", rays);
}

std::string disagreementsText(const JuryReport& report, std::size_t count) {
  std::string text;
  const std::size_t shown = std::min(count, report.disagreements.size());
  for (std::size_t i = 0; i < shown; ++i) {
    text += disagreementText(report, report.disagreements[i]);
  }
  return text;
}

Json reportJson(const JuryReport& report) {
  Json engines = Json::array();
  for (const EngineVerdict& engine : report.engines) {
    if (engine.tally.all().rays > 0) engines.push_back(engineJson(engine, report.bounces));
  }
  Json json = {{"name", report.name}, {"what", report.what}, {"rays", report.rays}};
  if (!report.bounces) {
    json["hits"] = report.hits;
    json["clean"] = report.clean;
    json["ambiguous"] = report.ambiguous;
    json["ties"] = report.ties;
  }
  json["nan_rays"] = report.unanswerable;
  json["gpu_cpu_compared"] = report.twinsCompared;
  json["gpu_cpu_differ"] = report.twinsDiffer;
  json["failed"] = report.failed();
  json["engines"] = engines;
  return json;
}

}  // namespace twintrace
