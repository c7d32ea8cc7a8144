#include "common/cast/case_csv.h"
#include "cpu/embree_caster.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

namespace twintrace {
namespace {

using Json = nlohmann::json;

const std::string kShipped = TWINTRACE_SOURCE_DIR "/experiments/cases/embree-";

/// Whether every code path of Embree 3.13.5, whatever the processor has, errs in a scene.
bool isWrongEverywhere(const std::string& scene) {
  return scene.find("any") != std::string::npos;
}

int wrongEverywhereCount(const CaseSet& cases) {
  int count = 0;
  for (std::size_t i = 0; i < cases.scenes.size(); ++i) {
    count += isWrongEverywhere(sceneName(cases, i));
  }
  return count;
}

/// The jury's report on shipped cases.
Json juryOn(const std::string& issue) {
  const test::TemporaryDirectory directory;
  const test::ProgramResult result = test::runProgram(
      directory,
      {"cast", "--cases", kShipped + issue + ".csv", "--intersector", "robust", "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  return result.json()["reports"][0];
}

}  // namespace

TEST_CASE("the jury holds Embree's known wrong hits against Embree alone", "[cast][gl]") {
  for (const std::string issue : {"387", "423"}) {
    INFO("issue " << issue);
    const CaseSet cases = readCases(kShipped + issue + ".csv").cases;
    const Json report = juryOn(issue);
    CHECK(report["clean"] == cases.rays.size());
    CHECK(report["hits"] == 0);
    for (const Json& engine : report["engines"]) {
      INFO(engine.dump());
      if (engine["engine"] == "embree") {
        // Another version may have mended them.
        if (embreeVersion() != "3.13.5") continue;
        CHECK(engine["clean"]["false_hits"] >= wrongEverywhereCount(cases));
      } else {
        CHECK(engine["asked"] == cases.rays.size());
        CHECK(engine["inexcusable"] == 0);
      }
    }
  }
}

}  // namespace twintrace
