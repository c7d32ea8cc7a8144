#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;

TEST_CASE("probe reports a function's distances as JSON", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"probe", "arcCosine", "--samples", "1000", "--json", "-"});
  REQUIRE(result.exitCode == 0);
  const auto json = result.json();
  REQUIRE(json["functions"].size() == 1);
  const auto& function = json["functions"][0];
  CHECK(function["signature"] == "arcCosine(float)");
  CHECK(function["verdict"] == "identical");
  CHECK(function["differing"] == 0);
  for (const char* other : {"gpu_to_float", "gpu_to_double", "gpu_to_correctly_rounded"}) {
    std::size_t sum = 0;
    for (const auto& [bin, count] : function[other]["ulp"].items()) sum += count.get<std::size_t>();
    CHECK(sum == function[other]["records"]);
  }
  CHECK(function["gpu_to_correctly_rounded"]["worst"].contains("words"));
}

TEST_CASE("probe finds a fault in a user's shader", "[cli][gl]") {
  const TemporaryDirectory directory;
  std::string text = readBytes(TWINTRACE_SOURCE_DIR "/shaders/math.glsl");
  const std::string right = "a.y * b.z - a.z * b.y";
  text.replace(text.find(right), right.size(), "a.y * b.z + a.z * b.y");
  writeBytes(directory.file("faulty.glsl"), text);
  const ProgramResult result =
      runProgram(directory, {"probe", "cross3", "dot3", "--samples", "1000", "--override",
                             "shaders/math.glsl=faulty.glsl"});
  CHECK(result.exitCode == 1);
  CHECK_THAT(result.out, Contains("worst record of cross3(vec3, vec3)"));
  CHECK_THAT(result.out, !Contains("worst record of dot3"));
}

TEST_CASE("probe replays a record", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"probe", "squareRoot", "--inputs", "2", "--json", "-"});
  REQUIRE(result.exitCode == 0);
  CHECK(result.json()["gpu"]["result"] == "0x1.6a09e6p+0 (1.41421354)");
  CHECK(result.json()["float"] == result.json()["gpu"]);
}

TEST_CASE("probe in native maths reports and does not fail", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"probe", "sine", "--samples", "1000", "--maths", "native"});
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("differs"));
}

TEST_CASE("probe refuses what it cannot run", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult unknown = runProgram(directory, {"probe", "arcCosin"});
  CHECK(unknown.exitCode == 2);
  CHECK_THAT(unknown.err, Contains("did you mean 'arcCosine'?"));
  CHECK(runProgram(directory, {"probe", "--samples", "0"}).exitCode == 2);
  CHECK(runProgram(directory, {"probe", "divide", "--inputs", "1,2"}).exitCode == 2);
  CHECK(runProgram(directory, {"probe", "dot3", "--inputs", "1,2"}).exitCode == 2);
}
