#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <sstream>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/cast/case_csv.h"
#include "common/cast/rays_csv.h"
#include "common/cast/scene_cases.h"
#include "cpu/exact/arbiter.h"
#include "experiments/arm.h"
#include "experiments/cast/hits_output.h"
#include "experiments/cast/jury_engines.h"
#include "experiments/cast/jury_text.h"
#include "experiments/cli/command.h"
#include "experiments/cli/command_line.h"
#include "experiments/cli/interrupt.h"
#include "experiments/cli/progress_display.h"
#include "experiments/cli/scene_input.h"
#include "experiments/cli/shared_options.h"
#include "experiments/outputs.h"

namespace twintrace {
namespace {

constexpr std::uint32_t kChunk = 1u << 16;  // rays heard at once: some 20 MB of them
constexpr std::size_t kMostSaved = 10000;   // disagreements per family that files take

/// What is to be cast.
struct Docket {
  std::string name;
  CaseSet cases;
  HitsFormat format = HitsFormat::cases;
  std::size_t nanRays = 0;
};

CaseSet raysBetween(const CaseSet& cases, std::size_t first, std::size_t end) {
  std::vector<std::size_t> rays(end - first);
  std::iota(rays.begin(), rays.end(), first);
  return selectRays(cases, rays);
}

template <class Hit>
bool isHit(const Hit& hit) {
  return hit.primitive >= 0;
}

template <class Hit>
void append(std::vector<Hit>& all, const std::vector<Hit>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

class CastCommand {
 public:
  explicit CastCommand(const Console& console) : console_(console) {}

  CLI::App* addTo(CLI::App& program) {
    CommandSyntax syntax(program, "cast",
                         "put rays before all engines and exact arithmetic, and judge the answers");
    syntax.option("scene", scenePath_, "scene file, with --rays").typeName("SCENE");
    syntax.option("--rays", raysPath_, "rays into the scene").typeName("RAYS.csv");
    syntax.option("--cases", casesPath_, "tiny scenes with their rays").typeName("CASES.csv");
    syntax.option("--family", family_, "a family of hard rays, or all").typeName("NAME|all");
    syntax.option("--count", count_, "rays of a family, 20000 unless said").range(1, 4000000000);
    syntax.option("--engine", engine_, oneOf(castEngineNames()) + "; jury unless said");
    syntax.option("-o,--output", hitsPath_, "answers; of families those that disagree")
        .typeName("HITS.csv");
    syntax.option("--list", listed_, "disagreements to print with hex floats");
    syntax.option("--save-cases", savedPath_, "disagreements as cases, to be cast again")
        .typeName("FILE.csv");
    addAnswerOptions(syntax, answer_);
    addRenderOptions(syntax, given_);
    return syntax.app();
  }

  int run() {
    checkUse();
    for (const std::string& path : {hitsPath_, savedPath_}) {
      if (!path.empty()) checkWritable(path);
    }
    checkDistinct(outputs());
    checkAnswer(answer_);
    if (!family_.empty()) return judgeFamilies();
    const Docket docket = raysPath_.empty() ? docketOfCases() : docketOfScene();
    if (docket.nanRays > 0) {
      console_.err << fmt::format(
          "twintrace: warning: {}: {} with a NaN, which {}\n", docket.name,
          docket.nanRays == 1 ? "1 ray" : fmt::format("{} rays", docket.nanRays),
          docket.nanRays == 1 ? "misses" : "miss");
    }
    return engine_ == "jury" ? judgeDocket(docket) : castDocket(docket);
  }

 private:
  void checkUse() const {
    const int sources = !raysPath_.empty() + !casesPath_.empty() + !family_.empty();
    if (sources != 1 || scenePath_.empty() != raysPath_.empty()) {
      throw UsageError("expected one of SCENE --rays RAYS.csv, --cases CASES.csv, --family NAME");
    }
    const auto& names = castEngineNames();
    if (std::find(names.begin(), names.end(), engine_) == names.end()) {
      throw UsageError("engine: found " + quote(engine_) + ", expected " + oneOf(names) +
                       didYouMean(engine_, names));
    }
  }

  std::vector<std::string> outputs() const {
    std::vector<std::string> paths;
    for (const std::string& path : {hitsPath_, savedPath_, answer_.json}) {
      if (!path.empty() && path != "-") paths.push_back(path);
    }
    return paths;
  }

  Docket docketOfScene() {
    const Scene scene = openScene(console_, scenePath_);
    options_ = applyOptions(scene.render, given_);
    const RaysFile file = readRays(raysPath_);
    return {scenePath_, casesOf(*flattenScene(scene, options_), file.rays), HitsFormat::rays,
            file.nanRays};
  }

  Docket docketOfCases() {
    options_ = applyOptions({}, given_);
    CasesFile file = readCases(casesPath_);
    return {casesPath_, std::move(file.cases), HitsFormat::cases, file.nanRays};
  }

  /// Asks one engine, without judging.
  int castDocket(const Docket& docket) {
    const auto engine = engine_ == "exact" ? nullptr : openCaseEngine(engine_, options_);
    const InterruptScope interrupt;
    std::vector<ExactHit> exact;
    std::vector<CastHit> answers;
    visitParts(docket.cases, interrupt, [&](const CaseSet& part) {
      if (engine) {
        append(answers, engine->cast(part));
      } else {
        append(exact, arbitrate(part));
      }
    });
    std::ostringstream text;
    HitsOutput output(text, docket.format);
    if (engine) {
      output.write(docket.cases, engine_, answers);
    } else {
      output.write(docket.cases, exact);
    }
    const auto hits = std::count_if(answers.begin(), answers.end(), isHit<CastHit>) +
                      std::count_if(exact.begin(), exact.end(), isHit<ExactHit>);
    const Json json = {{"name", docket.name},
                       {"engine", engine_},
                       {"rays", answers.size() + exact.size()},
                       {"hits", hits},
                       {"nan_rays", docket.nanRays},
                       {"provenance", machineJson()}};
    finish(json, hitsPath_.empty() ? text.str() : "", text.str(), {});
    return interrupt.interrupted() ? kInterrupted : kAgree;
  }

  int judgeDocket(const Docket& docket) {
    JuryBench bench = openBench();
    const InterruptScope interrupt;
    Jury jury(bench.engines, keptCount());
    std::vector<JuryReport> reports = {jury.open(docket.name, "")};
    JuryReport& report = reports.front();
    visitParts(docket.cases, interrupt, [&](const CaseSet& part) {
      jury.hear(report, part, Expectation::exact, report.rays);
    });
    std::ostringstream hits;
    if (!hitsPath_.empty()) writeAllAnswers(hits, docket, report.rays, bench);
    const int code = conclude(reports, bench, reportText(report), hits.str());
    return interrupt.interrupted() ? kInterrupted : code;
  }

  /// Visits all rays, or those before Ctrl-C, in parts that fit into memory and end soon.
  template <class Visitor>
  void visitParts(const CaseSet& cases, const InterruptScope& interrupt,
                  const Visitor& visit) const {
    const std::size_t total = cases.rays.size();
    if (total <= kChunk) return visit(cases);
    ProgressDisplay display(console_.err, ProgressDisplay::styleForStandardError(answer_.quiet));
    for (std::size_t first = 0; first < total; first += kChunk) {
      const std::size_t end = std::min<std::size_t>(first + kChunk, total);
      visit(raysBetween(cases, first, end));
      display.show({double(end) / double(total), 0, 0.0});
      if (interrupt.interrupted()) return;
    }
  }

  /// The answers of exact arithmetic and of all engines to the first `heard` rays.
  void writeAllAnswers(std::ostream& out, const Docket& docket, std::size_t heard,
                       const JuryBench& bench) const {
    const bool all = heard == docket.cases.rays.size();
    const CaseSet cases = all ? docket.cases : raysBetween(docket.cases, 0, heard);
    HitsOutput output(out, docket.format);
    output.write(cases, arbitrate(cases));
    for (const JuryEngine& engine : bench.engines) {
      output.write(cases, engine.label, engine.engine->cast(cases));
    }
  }

  int judgeFamilies() {
    options_ = applyOptions({}, given_);
    std::vector<Family> chosen = families();
    if (family_ != "all") chosen = {findFamily(family_)};
    JuryBench bench = openBench();
    const InterruptScope interrupt;
    const std::vector<JuryReport> reports = hear(chosen, bench, interrupt);
    std::ostringstream hits;
    HitsOutput output(hits, HitsFormat::cases);
    for (const JuryReport& report : reports) output.write(report);
    const std::string text = family_ == "all" ? summaryText(reports) : reportText(reports.front());
    const int code = conclude(reports, bench, text, hits.str());
    return interrupt.interrupted() ? kInterrupted : code;
  }

  std::vector<JuryReport> hear(const std::vector<Family>& chosen, JuryBench& bench,
                               const InterruptScope& interrupt) const {
    ProgressDisplay display(console_.err, ProgressDisplay::styleForStandardError(answer_.quiet));
    Jury jury(bench.engines, keptCount());
    std::vector<JuryReport> reports;
    const double total = double(chosen.size()) * double(count_);
    double done = 0;
    for (const Family& family : chosen) {
      reports.push_back(jury.open(family.name, family.what));
      for (std::uint64_t first = 0; first < count_; first += kChunk) {
        const auto count =
            static_cast<std::uint32_t>(std::min<std::uint64_t>(kChunk, count_ - first));
        const CaseSet cases = drawFamily(family.name, count, options_.seed, first);
        jury.hear(reports.back(), cases, family.expectation, first);
        done += count;
        display.show({done / total, 0, 0.0});
        if (interrupt.interrupted()) return reports;
      }
    }
    return reports;
  }

  JuryBench openBench() const {
    if (engine_ == "jury") return openJury(options_);
    JuryBench bench;
    if (engine_ == "exact") return bench;
    const bool trusted = engine_ != "embree" && options_.intersector == Intersector::robust;
    bench.engines.push_back({engine_, trusted, true, openCaseEngine(engine_, options_)});
    return bench;
  }

  std::size_t keptCount() const {
    const bool toFile = !savedPath_.empty() || (!hitsPath_.empty() && !family_.empty());
    return toFile ? std::max(kMostSaved, listed_) : listed_;
  }

  int conclude(const std::vector<JuryReport>& reports, const JuryBench& bench, std::string text,
               const std::string& hits) const {
    for (const JuryReport& report : reports) text += disagreementsText(report, listed_);
    for (const std::string& note : bench.notes) text += "note: " + note + "\n";
    text += juryVerdictText(reports);
    const bool failed = std::any_of(reports.begin(), reports.end(),
                                    [](const JuryReport& report) { return report.failed(); });
    Json list = Json::array();
    std::vector<Disagreement> saved;
    for (const JuryReport& report : reports) {
      list.push_back(reportJson(report));
      // A case has no bounce to be saved.
      if (report.bounces) continue;
      saved.insert(saved.end(), report.disagreements.begin(), report.disagreements.end());
    }
    const Json json = {
        {"engine", engine_},    {"count", count_}, {"seed", options_.seed},      {"failed", failed},
        {"notes", bench.notes}, {"reports", list}, {"provenance", machineJson()}};
    finish(json, text, hits, saved);
    return failed ? kDiffer : kAgree;
  }

  void finish(const Json& json, const std::string& text, const std::string& hits,
              const std::vector<Disagreement>& saved) const {
    OutputAttempts outputs;
    outputs.attempt([&] { answer(console_, answer_, json, text); });
    if (!hitsPath_.empty()) outputs.attempt([&] { writeText(hitsPath_, hits); });
    if (!savedPath_.empty()) {
      std::ostringstream cases;
      writeCases(cases, casesOf(saved));
      outputs.attempt([&] { writeText(savedPath_, cases.str()); });
    }
    outputs.finish();
  }

  Console console_;
  std::string scenePath_;
  std::string raysPath_;
  std::string casesPath_;
  std::string family_;
  std::uint64_t count_ = 20000;
  std::string engine_ = "jury";
  std::string hitsPath_;
  std::string savedPath_;
  std::size_t listed_ = 0;
  RenderOptions options_;
  AnswerOptions answer_;
  GivenOptions given_;
};

}  // namespace

Command addCastCommand(CLI::App& program, const Console& console) {
  const auto command = std::make_shared<CastCommand>(console);
  return {command->addTo(program), [command] { return command->run(); }};
}

}  // namespace twintrace
