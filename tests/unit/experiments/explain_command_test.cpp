#include <cstdlib>

#include "gpu/shader_source.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

namespace twintrace::test {
namespace {

using Json = nlohmann::json;

/// Explains a sample of the Cornell box at 16x16 pixels, between two tracers on the CPU unless
/// said.
ProgramResult explain(const TemporaryDirectory& directory, const std::vector<std::string>& more) {
  return runProgram(directory, onCornell("explain", more));
}

/// math.glsl whose dot3 is one ulp too large, as a value of --override.
std::string faultyDot(const TemporaryDirectory& directory) {
  const std::string from = "(a.x * b.x + a.y * b.y) + a.z * b.z;\n  return result;";
  std::string text = ShaderLibrary().find("math.glsl").value().text;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(),
               "(a.x * b.x + a.y * b.y) + a.z * b.z;\n"
               "  return intBitsToFloat(floatBitsToInt(result) + 1);");
  writeBytes(directory.file("math.glsl"), text);
  return "shaders/math.glsl=" + directory.file("math.glsl");
}

/// As little as a program can be made of.
constexpr const char* kBall = R"toml(
name = "ball"
[camera]
eye = [0, 0, 3]
target = [0, 0, 0]
fov = 40.0
[render]
integrator = "local"
[materials.m]
albedo = [0.5, 0.6, 0.7]
[[objects]]
name = "ball"
shape = "sphere"
center = [0, 0, 0]
radius = 1.0
material = "m"
[[lights]]
kind = "point"
position = [2.0, 3.0, 3.0]
intensity = [9.0, 8.0, 7.0]
)toml";

}  // namespace

TEST_CASE("explain refuses a pixel outside the film", "[explain]") {
  const TemporaryDirectory directory;
  for (const char* pixel : {"16,0", "0,16", "-1,0"}) {
    INFO(pixel);
    const ProgramResult result = explain(directory, {"--pixel=" + std::string(pixel)});
    CHECK(result.exitCode == 2);
    CHECK_THAT(result.err, Catch::Contains("expected x from 0 to 15 and y from 0 to 15"));
  }
}

TEST_CASE("explain refuses what is no pixel", "[explain]") {
  const TemporaryDirectory directory;
  for (const char* pixel : {"3", "3,", ",3", "3,4,5", "3;4", "a,b"}) {
    INFO(pixel);
    const ProgramResult result = explain(directory, {"--pixel=" + std::string(pixel)});
    CHECK(result.exitCode == 2);
    CHECK_THAT(result.err, Catch::Contains("expected X,Y"));
  }
  CHECK(explain(directory, {}).exitCode == 2);
}

TEST_CASE("explain refuses a sample that no index has", "[explain]") {
  const TemporaryDirectory directory;
  for (const char* sample : {"-1", "4294967296"}) {
    INFO(sample);
    const ProgramResult result =
        explain(directory, {"--pixel=3,4", "--sample=" + std::string(sample)});
    CHECK(result.exitCode == 2);
    CHECK_THAT(result.err, Catch::Contains("sample: found " + std::string(sample)));
  }
}

TEST_CASE("explain exits with 0 where both arms agree", "[explain]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      explain(directory, {"--pixel", "3,4", "--sample", "2", "--b", "backend=cpu", "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const Json json = result.json();
  CHECK(json["x"] == 3);
  CHECK(json["y"] == 4);
  CHECK(json["sample"] == 2);
  CHECK(json["identical"] == true);
  CHECK(json["class"].is_null());
  CHECK(json["first"].is_null());
  CHECK(json["parted_at_vertex"] == -1);
  CHECK(json["radiance_a"] == json["radiance_b"]);
  CHECK(json["vertices_a"] == json["vertices_b"]);
  CHECK_FALSE(json["vertices_a"].empty());
}

TEST_CASE("explain says that no sample differs", "[explain]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      explain(directory, {"--pixel", "3,4", "--spp", "4", "--b", "backend=cpu"});
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.out, Catch::Contains("none of the samples 0 to 3 differs"));
}

TEST_CASE("explain exits with 1 and names the function of an overridden shader", "[explain][gl]") {
  const TemporaryDirectory directory;
  // A sample whose radiance shows the fault; most round it off.
  const ProgramResult result = runProgram(
      directory, {"explain", TWINTRACE_SOURCE_DIR "/experiments/scenes/local-lights.toml",
                  "--width", "16", "--height", "16", "--pixel", "0,2", "--sample", "3",
                  "--override", faultyDot(directory), "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 1);
  const Json json = result.json();
  CHECK(json["identical"] == false);
  CHECK(json["class"] == "rounding");
  const Json& first = json["first"];
  CHECK(first["function"] == "dot3");
  CHECK_THAT(first["place_a"].get<std::string>(), Catch::Contains("math.h:"));
  CHECK_THAT(first["place_b"].get<std::string>(), Catch::Contains("math.glsl:"));
  CHECK(first["inputs"].contains("a.x"));
  REQUIRE(first["differing"].size() == 1);
  CHECK(first["differing"][0]["ulp"] == 1);
  CHECK_THAT(first["differing"][0]["a"]["hex"].get<std::string>(), Catch::Contains("0x"));
}

TEST_CASE("explain gives a command that names the statement", "[explain][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(
      directory, {"explain", TWINTRACE_SOURCE_DIR "/experiments/scenes/local-lights.toml",
                  "--width", "16", "--height", "16", "--pixel", "0,2", "--sample", "3",
                  "--override", faultyDot(directory), "--json", "-"});
  REQUIRE(result.exitCode == 1);
  const std::string command = result.json()["first"]["replay"];
  REQUIRE_THAT(command, Catch::StartsWith("twintrace probe 'dot3(vec3, vec3)' --inputs 0x"));
  const std::string answer = directory.file("answer.json");
  const int status = std::system((std::string(TWINTRACE_BINARY) + command.substr(9) +
                                  " --quiet --json " + answer)
                                     .c_str());
  CHECK(WEXITSTATUS(status) == 1);
  const Json json = Json::parse(readBytes(answer));
  CHECK(json["statements"]["function"] == "dot3");
  CHECK(json["statements"]["statement"]["gpu"]["text"] ==
        "return intBitsToFloat(floatBitsToInt(result) + 1);");
  const Json ofExplain = result.json()["first"]["differing"][0];
  CHECK(json["statements"]["differing"][0]["gpu"] == ofExplain["b"]);
  CHECK(json["statements"]["differing"][0]["float"] == ofExplain["a"]);
}

TEST_CASE("explain in native maths says that a trace no longer differs", "[explain][gl]") {
  const TemporaryDirectory directory;
  // Mesa makes one power of a product of two; not so if both are traced, and the first is infinite.
  const std::string right = "  return result;\n";
  std::string text = ShaderLibrary().find("hash.glsl").value().text;
  text.replace(text.find(right, text.find("float unitFloat(")), right.size(),
               "  float first = exp2(200.0f + result);\n  float second = exp2(-100.0f - result);\n"
               "  return result + 1.0e24f / (first * second);\n");
  writeBytes(directory.file("hash.glsl"), text);
  writeBytes(directory.file("ball.toml"), kBall);
  const ProgramResult result = runProgram(
      directory, {"explain", "ball.toml", "--width", "16", "--height", "16", "--spp", "2", "--pixel",
                  "8,8", "--a", "backend=gpu,maths=native", "--b",
                  "backend=gpu,maths=native,override=shaders/hash.glsl=hash.glsl"});
  INFO(result.err);
  if (result.exitCode == 0) {
    WARN("this driver compiles traced programs as it does plain ones");
    return;
  }
  CHECK(result.exitCode == 1);
  CHECK_THAT(result.out, Catch::Contains("pixel 8,8, sample 0"));
  CHECK_THAT(result.out, Catch::Contains("the traced ones no longer do"));
  CHECK_THAT(result.out, Catch::Contains("b: the traced program does not show what"));
}

}  // namespace twintrace::test
