#include <algorithm>

#include "gpu/shader_source.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

namespace twintrace {
namespace {

using test::ProgramResult;
using test::runProgram;
using test::TemporaryDirectory;

using Json = nlohmann::json;

/// A jury's JSON on families, from a run of the program.
ProgramResult castFamily(const TemporaryDirectory& directory, const std::string& family,
                         const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"cast", "--family", family, "--count", "300", "--json", "-"};
  words.insert(words.end(), more.begin(), more.end());
  return runProgram(directory, words);
}

Json engineOf(const Json& report, const std::string& name) {
  for (const Json& engine : report["engines"]) {
    if (engine["engine"] == name) return engine;
  }
  return {};
}

const std::string kTwoCases =
    "scene,ball\n"
    "sphere,s,0,0,0,1\n"
    "ray,through,0,0,-3,0,0,1,0,inf\n"
    "ray,beside,2,0,-3,0,0,1,0,inf\n";

}  // namespace

TEST_CASE("cast wants one source of rays", "[cast]") {
  const TemporaryDirectory directory;
  const std::string expected = "expected one of SCENE --rays";
  CHECK_THAT(runProgram(directory, {"cast"}).err, Catch::Contains(expected));
  const auto both = runProgram(directory, {"cast", "--family", "all", "--cases", "x.csv"});
  CHECK_THAT(both.err, Catch::Contains(expected));
  CHECK(both.exitCode == 2);
  CHECK(runProgram(directory, {"cast", test::kCornell}).exitCode == 2);
}

TEST_CASE("cast suggests the nearest family and engine", "[cast]") {
  const TemporaryDirectory directory;
  const ProgramResult family = castFamily(directory, "sphere-tangnet", {"--engine", "cpu"});
  CHECK(family.exitCode == 2);
  CHECK_THAT(family.err, Catch::Contains("did you mean 'sphere-tangent'?"));
  const ProgramResult engine = castFamily(directory, "sphere-tangent", {"--engine", "cpu46"});
  CHECK(engine.exitCode == 2);
  CHECK_THAT(engine.err, Catch::Contains("did you mean 'cpu64'?"));
}

TEST_CASE("cast --engine writes one engine's answers to cases", "[cast]") {
  const TemporaryDirectory directory;
  test::writeBytes(directory.file("cases.csv"), kTwoCases);
  for (const std::string engine : {"cpu", "cpu64", "embree", "exact"}) {
    const ProgramResult result =
        runProgram(directory, {"cast", "--cases", "cases.csv", "--engine", engine});
    INFO(engine << result.err);
    CHECK(result.exitCode == 0);
    CHECK_THAT(result.out, Catch::StartsWith("scene,ray,engine,prim,t,nx,ny,nz,class\n"));
    CHECK_THAT(result.out, Catch::Contains("ball,through," + engine + ",s,0x1p+1,"));
    CHECK_THAT(result.out, Catch::Contains("ball,beside," + engine + ",-1,"));
  }
}

TEST_CASE("cast counts rays with a NaN and lets them miss", "[cast]") {
  const TemporaryDirectory directory;
  test::writeBytes(directory.file("rays.csv"),
                   "ox,oy,oz,dx,dy,dz,tmin,tmax\n0,1,3,0,0,-1,0,inf\n0,nan,3,0,0,-1,0,inf\n");
  const ProgramResult result =
      runProgram(directory, {"cast", test::kCornell, "--rays", "rays.csv", "--engine", "cpu"});
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Catch::Contains("1 ray with a NaN, which misses"));
  CHECK_THAT(result.out, Catch::Contains("0,cpu,1,"));
  CHECK_THAT(result.out, Catch::Contains("1,cpu,0,"));
}

TEST_CASE("cast reports all bad rows of cases", "[cast]") {
  const TemporaryDirectory directory;
  test::writeBytes(directory.file("bad.csv"), "scene,a\nsphere,s,0,0,x,1\ncone,c,1\n");
  const ProgramResult result = runProgram(directory, {"cast", "--cases", "bad.csv"});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Catch::Contains("bad.csv:2:"));
  CHECK_THAT(result.err, Catch::Contains("bad.csv:3:"));
  CHECK(runProgram(directory, {"cast", "--cases", "none.csv"}).exitCode == 4);
}

TEST_CASE("cast judges a family by exact arithmetic", "[cast]") {
  const TemporaryDirectory directory;
  const ProgramResult result = castFamily(directory, "sphere-generic", {"--engine", "cpu"});
  REQUIRE(result.exitCode == 0);
  const Json report = result.json()["reports"][0];
  CHECK(report["rays"] == 300);
  CHECK(report["hits"] > 100);
  CHECK(report["clean"] > 290);
  CHECK(engineOf(report, "cpu")["clean"]["false_misses"] == 0);
  CHECK(engineOf(report, "cpu")["clean"]["distance_error_max"] <= 5.0);
}

TEST_CASE("the report's intersector shows its failures without failing the check", "[cast]") {
  const TemporaryDirectory directory;
  const ProgramResult result = castFamily(directory, "sphere-direction-long",
                                          {"--engine", "cpu", "--intersector", "report"});
  CHECK(result.exitCode == 0);
  const Json report = result.json()["reports"][0];
  CHECK(engineOf(report, "cpu")["clean"]["false_misses"] > 100);
}

TEST_CASE("cast saves what an engine gets wrong as cases that show it again", "[cast]") {
  const TemporaryDirectory directory;
  const std::vector<std::string> report = {"--engine", "cpu", "--intersector", "report"};
  std::vector<std::string> saving = report;
  saving.insert(saving.end(), {"--save-cases", "saved.csv", "-o", "hits.csv"});
  castFamily(directory, "sphere-direction-long", saving);
  const ProgramResult again = runProgram(
      directory, {"cast", "--cases", "saved.csv", "--intersector", "report", "--engine", "exact"});
  REQUIRE(again.exitCode == 0);
  const std::string hits = test::readBytes(directory.file("hits.csv"));
  const auto exactLines = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(",exact,", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  CHECK(exactLines(hits) > 100);
  CHECK(exactLines(again.out) == exactLines(hits));
  // The same answers to the last bit.
  const std::size_t first = hits.find(",exact,");
  const std::string line = hits.substr(first, hits.find('\n', first) - first);
  CHECK_THAT(again.out, Catch::Contains(line));
}

TEST_CASE("cast --list prints disagreements with hex floats", "[cast]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"cast", "--family", "sphere-direction-long", "--count", "50",
                             "--engine", "cpu", "--intersector", "report", "--list", "2"});
  CHECK_THAT(result.out, Catch::Contains("false-miss"));
  CHECK_THAT(result.out, Catch::Contains("  sphere 0x"));
  CHECK_THAT(result.out, Catch::Contains("  ray 0x") || Catch::Contains("  ray -0x"));
}

TEST_CASE("the jury finds gpu and cpu equal in each bit", "[cast][gl]") {
  const TemporaryDirectory directory;
  for (const std::string family : {"scene-mixed", "self-hit-plane"}) {
    const ProgramResult result = castFamily(directory, family);
    INFO(result.out << result.err);
    CHECK(result.exitCode == 0);
    const Json report = result.json()["reports"][0];
    CHECK(report["gpu_cpu_compared"] == 300);
    CHECK(report["gpu_cpu_differ"] == 0);
  }
}

TEST_CASE("the jury compares the bits of the report's intersector too", "[cast][gl]") {
  const TemporaryDirectory directory;
  std::string text = ShaderLibrary().find("intersect_report.glsl").value().text;
  const std::string from = "t >= 1e-4f";
  REQUIRE(text.find(from) != std::string::npos);
  text.replace(text.find(from), from.size(), "t >= 1e-1f");
  test::writeBytes(directory.file("mine.glsl"), text);
  const ProgramResult result =
      castFamily(directory, "plane-generic",
                 {"--override", "shaders/intersect_report.glsl=" + directory.file("mine.glsl")});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 1);
  CHECK(result.json()["reports"][0]["gpu_cpu_differ"] > 0);
}

}  // namespace twintrace
