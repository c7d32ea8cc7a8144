#include "experiments/passport/passport_json.h"
#include "experiments/passport/stored_passports.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"
#include "tests/unit/gpu/inexact_shaders.h"

using namespace twintrace;
using namespace twintrace::test;
using Catch::Matchers::Contains;

namespace {

std::string lastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  const std::size_t start = text.rfind('\n', end);
  return text.substr(start + 1, end - start);
}

}  // namespace

TEST_CASE("info --passport measures the GL and ends with whether it is strict", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"info", "--passport", "--json", "passport.json"});
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(lastLine(result.out), Catch::Matchers::StartsWith("strict: "));
  const auto passport = nlohmann::json::parse(readBytes(directory.file("passport.json")))["passport"];
  CHECK(passport["digest"].get<std::string>().size() == 32);
  CHECK(passport["facts"]["addition"] == "correctly rounded");
  CHECK(passport["builtins"].size() > 20);
  for (const auto& builtin : passport["builtins"]) {
    INFO(builtin["name"]);
    CHECK(builtin["max_ulp"].is_number());
    CHECK(builtin["within_allowance"].is_null() == (builtin["allowance"] == "inherited, no number" ||
                                                    builtin["allowance"] ==
                                                        "none: undefined precision"));
  }
}

TEST_CASE("render says which passport its GL has", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, onCornell("render", {"--backend", "gpu", "--spp", "1", "--json", "-"}));
  REQUIRE(result.exitCode == 0);
  const auto ran = result.json()["provenance"]["arm"]["ran"];
  CHECK(ran["passport"].get<std::string>().size() == 32);
  CHECK(ran.contains("strict"));
  CHECK(ran.contains("division"));
}

TEST_CASE("compare keeps the passport and warns when a later run's differs", "[cli][gl]") {
  const TemporaryDirectory directory;
  const auto words = onCornell("compare", {"--spp", "1", "--out", "out"});
  const ProgramResult first = runProgram(directory, words);
  REQUIRE(first.exitCode == 0);
  CHECK_THAT(first.err, !Contains("passport.json"));
  CHECK_THAT(runProgram(directory, words).err, !Contains("passport.json"));
  const std::string path = directory.file("out/passport.json");
  auto stored = nlohmann::json::parse(readBytes(path));
  stored["b"]["facts"]["division"] = "something else";
  writeBytes(path, stored.dump());
  const ProgramResult second = runProgram(directory, words);
  CHECK(second.exitCode == 0);
  CHECK_THAT(second.err, Contains("passport.json belongs to: it differs in division\n"));
}

TEST_CASE("render warns once if strict maths can't be strict", "[cli][gl]") {
  const TemporaryDirectory directory;
  const std::string shaders = directory.file("shaders");
  std::filesystem::copy(TWINTRACE_SOURCE_DIR "/shaders", shaders,
                        std::filesystem::copy_options::recursive);
  writeBytes(shaders + "/" + kCorrectedShader, withoutCorrection());
  const ProgramResult result = runProgram(
      directory, onCornell("render", {"--backend", "gpu", "--spp", "1", "--shader-dir", shaders}));
  CHECK(result.exitCode == 0);
  const std::string warning = "strict maths is not strict on this GL: corrected division (";
  CHECK_THAT(result.err, Contains(warning));
  CHECK_THAT(result.err, Contains("twintrace info --passport --gl osmesa"));
  CHECK(result.err.find(warning) == result.err.rfind(warning));
}

TEST_CASE("passportWarnings says nothing about files that are missing or damaged", "[unit]") {
  const TemporaryDirectory directory;
  const Json passports = {{"b", {{"facts", {{"division", "correctly rounded"}}}}}};
  const std::string path = directory.file("passport.json");
  CHECK(passportWarnings(path, passports).empty());
  writeBytes(path, "{\"b\": [1, 2");
  CHECK(passportWarnings(path, passports).empty());
}
