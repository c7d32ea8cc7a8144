#include <algorithm>

#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;

namespace {

/// math.glsl whose dot3 is one ulp too large, as a value of --override.
std::string faultyDot(const TemporaryDirectory& directory) {
  std::string text = readBytes(TWINTRACE_SOURCE_DIR "/shaders/math.glsl");
  const std::string right = "(a.x * b.x + a.y * b.y) + a.z * b.z;\n  return result;";
  text.replace(text.find(right), right.size(),
               "(a.x * b.x + a.y * b.y) + a.z * b.z;\n"
               "  return intBitsToFloat(floatBitsToInt(result) + 1);");
  writeBytes(directory.file("faulty.glsl"), text);
  return "shaders/math.glsl=faulty.glsl";
}

/// `file:line` of a text in the file that faultyDot() wrote.
std::string placeOf(const TemporaryDirectory& directory, const std::string& part) {
  const std::string text = readBytes(directory.file("faulty.glsl"));
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(part));
  return "faulty.glsl:" + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

}  // namespace

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

TEST_CASE("probe names the statement of a planted fault", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"probe", "dot3", "--inputs", "1,2,3,4,5,6", "--statements",
                             "--override", faultyDot(directory), "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 1);
  const auto found = result.json()["statements"];
  CHECK(found["traced_as_plain"] == true);
  CHECK(found["function"] == "dot3");
  const auto& gpu = found["statement"]["gpu"];
  CHECK(gpu["text"] == "return intBitsToFloat(floatBitsToInt(result) + 1);");
  CHECK(gpu["place"] == placeOf(directory, gpu["text"]));
  CHECK_THAT(found["statement"]["float"]["place"].get<std::string>(),
             Contains("cpu/kernel/math.h:"));
  REQUIRE(found["differing"].size() == 1);
  CHECK(found["differing"][0]["gpu"]["hex"] == "0x1.000002p+5");
  CHECK(found["differing"][0]["float"]["hex"] == "0x1p+5");
  CHECK(found["differing"][0]["ulp"] == 1);
}

TEST_CASE("probe goes on to the call that a statement's fault comes from", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(directory, {"probe", "length3", "--inputs", "2,3,6",
                                                      "--statements", "--override",
                                                      faultyDot(directory)});
  INFO(result.err);
  REQUIRE(result.exitCode == 1);
  CHECK_THAT(result.out, Contains("the difference comes from a call of dot3 inside"));
  CHECK_THAT(result.out, Contains(placeOf(directory, "return intBitsToFloat") +
                                  "  return intBitsToFloat(floatBitsToInt(result) + 1);"));
  CHECK_THAT(result.out, Contains("gpu   0x1.880002p+5 (49.0000038)"));
  CHECK_THAT(result.out, Contains("float 0x1.88p+5 (49)  1 ulp"));
}

TEST_CASE("probe finds no statement where both sides agree", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"probe", "reflect3", "--inputs", "1,2,3,0,1,0", "--statements"});
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("the results agree: no statement is named"));
  CHECK_THAT(result.out, !Contains("note:"));
}

TEST_CASE("probe in native maths says that a trace no longer differs", "[cli][gl]") {
  const TemporaryDirectory directory;
  // Mesa makes one power of a product of two; not so if both are traced, and the first is infinite.
  const std::string right = "return dot(a, b);";
  std::string text = readBytes(TWINTRACE_SOURCE_DIR "/shaders/math_native.glsl");
  text.replace(text.find(right), right.size(),
               "float sum = (a.x * b.x + a.y * b.y) + a.z * b.z;\n"
               "  float first = exp2(200.0f * a.x);\n  float second = exp2(-100.0f * b.x);\n"
               "  return sum + 1.0e30f / (first * second);");
  writeBytes(directory.file("native.glsl"), text);
  const ProgramResult result = runProgram(
      directory, {"probe", "dot3", "--inputs", "1,2,3,1,5,6", "--statements", "--maths", "native",
                  "--override", "shaders/math_native.glsl=native.glsl", "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const auto json = result.json();
  if (json["gpu"] == json["float"]) {
    WARN("this driver compiles traced programs as it does plain ones");
    return;
  }
  CHECK(json["statements"]["traced_as_plain"] == false);
  CHECK(json["statements"]["notes"][0] ==
        "the shader with its statements traced no longer shows the difference");
}

TEST_CASE("probe runs a function in the scene that is named", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"probe", "fetchCamera", "--inputs", "", "--statements", "--scene",
                             kCornell, "--width", "16", "--height", "16", "--json", "-"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  const auto json = result.json();
  CHECK(json["world"] == "scene");
  CHECK(json["gpu"]["result.origin.z"] == "0x1.f33334p+1 (3.9000001)");
  CHECK(json["statements"]["function"].is_null());
}

TEST_CASE("probe refuses options without those that they belong to", "[cli]") {
  const TemporaryDirectory directory;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
    const ProgramResult result = runProgram(directory, words);
    CHECK(result.exitCode == 2);
    CHECK_THAT(result.err, Contains(message));
  };
  refused({"probe", "dot3", "--statements"}, "found --statements without --inputs");
  refused({"probe", "dot3", "--scene", kCornell}, "found --scene without --inputs");
  refused({"probe", "dot3", "--inputs", "1,2,3,4,5,6", "--noise", "sine"},
          "found --noise without --scene");
  refused({"probe", "fetchTexel", "--inputs", "0", "--statements"},
          "expected a function with a twin");
}
