#include "experiments/probe/user_shader.h"

#include <bit>
#include <set>

#include "common/base/error.h"
#include "experiments/probe/user_reference.h"
#include "experiments/probe/user_trial.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

namespace twintrace::test {
namespace {

using Catch::Contains;

std::string errorOf(const std::string& text) {
  try {
    probe::parseUserShader(text, "a.glsl", {});
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

/// probe --shader of a text, with more arguments behind.
ProgramResult probeText(const TemporaryDirectory& directory, const std::string& text,
                        std::vector<std::string> more = {}) {
  writeBytes(directory.file("a.glsl"), text);
  std::vector<std::string> words = {"probe", "--shader", "a.glsl", "--samples", "2000"};
  words.insert(words.end(), more.begin(), more.end());
  return runProgram(directory, words);
}

const std::string kExamples = TWINTRACE_SOURCE_DIR "/experiments/examples/";

}  // namespace

TEST_CASE("parseUserShader takes scalars, vectors and out parameters", "[probe]") {
  const auto shader = probe::parseUserShader(
      "#version 450\nfloat f(vec3 a, out int b, inout uvec2 c, bool d) { return a.x; }", "a.glsl",
      {});
  REQUIRE(shader.functions.size() == 1);
  CHECK(probe::wordCount(shader.functions[0].inputs()) == 6);
  CHECK(probe::wordCount(shader.functions[0].outputs()) == 4);
  CHECK(shader.text.find("#version") == std::string::npos);
}

TEST_CASE("parseUserShader names the place of every type that it can't pack", "[probe]") {
  const std::string error = errorOf("mat3 f(float x) { }\nfloat g(\n  sampler2D s) { }\n");
  CHECK_THAT(error, Contains("a.glsl:1:1: found type 'mat3'"));
  CHECK_THAT(error, Contains("a.glsl:3:3: found type 'sampler2D'"));
}

TEST_CASE("parseUserShader refuses main, functions without results and unknown names", "[probe]") {
  CHECK_THAT(errorOf("void main() {}"), Contains("found main"));
  CHECK_THAT(errorOf("void f(float x) {}"), Contains("without a result"));
  CHECK_THAT(errorOf("int k;"), Contains("found no function"));
  CHECK_THROWS_WITH(probe::parseUserShader("float shade() { return 1.0; }", "a.glsl", {"shad"}),
                    Contains("did you mean 'shade'?"));
}

TEST_CASE("parseUserShader reads ranges and reports what it can't read", "[probe]") {
  const auto shader = probe::parseUserShader(
      "// twintrace: x in [-1, 0x1p3], n unit\nfloat f(float x, vec3 n) { return x; }", "a.glsl",
      {});
  CHECK(shader.functions[0].parameters[0].range->low == -1);
  CHECK(shader.functions[0].parameters[0].range->high == 8);
  CHECK(shader.functions[0].parameters[1].range->unit);
  const std::string f = "\nfloat f(float x) { return x; }";
  CHECK_THAT(errorOf("// twintrace: y in [0, 1]" + f),
             Contains("expected a parameter of f(float)"));
  CHECK_THAT(errorOf("// twintrace: x in [1, 0]" + f), Contains("two ascending numbers"));
  CHECK_THAT(errorOf("// twintrace: x between 0 and 1" + f), Contains("a.glsl:1:1"));
  CHECK_THAT(errorOf("// twintrace: x unit" + f), Contains("found unit for a float"));
}

TEST_CASE("drawUserInputs stays within the ranges and goes to their ends", "[probe]") {
  const auto shader = probe::parseUserShader(
      "// twintrace: x in [2, 3], i in [-1, 1], n unit\n"
      "float f(float x, int i, vec2 n) { return x; }",
      "a.glsl", {});
  const auto words = probe::drawUserInputs(shader.functions[0], 500, 1);
  std::set<float> numbers;
  std::set<int> integers;
  for (std::size_t at = 0; at < words.size(); at += 4) {
    numbers.insert(std::bit_cast<float>(words[at]));
    integers.insert(static_cast<int>(words[at + 1]));
    const double x = std::bit_cast<float>(words[at + 2]);
    const double y = std::bit_cast<float>(words[at + 3]);
    REQUIRE(x * x + y * y == Approx(1.0));
  }
  CHECK(*numbers.begin() == 2.0f);
  CHECK(*numbers.rbegin() == 3.0f);
  CHECK(numbers.size() > 400);
  CHECK(integers == std::set<int>{-1, 0, 1});
}

TEST_CASE("probe --shader agrees with the same text in double", "[probe][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      probeText(directory,
                "#include \"math.glsl\"\nstruct Pair { float a; float b; };\n"
                "Pair pair(float a, float b) { return Pair(a, b); }\n"
                "// twintrace: v in [0.1, 1]\n"
                "float f(in vec3 v, out vec2 w) {\n"
                "  w = v.zy * 2.0f;\n"
                "  Pair p = pair(dot(v, v.zyx), 0.1);\n"
                "  return sqrt(p.a) + p.b + dot3(v, v);\n}\n",
                {"f"});
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("agreement of f(vec3, vec2)"));
}

TEST_CASE("probe --shader's reference reads components by all their names", "[probe][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      probeText(directory,
                "// twintrace: c in [0.1, 1]\n"
                "vec3 f(vec4 c) {\n"
                "  dvec2 wide = dvec2(c.r, c.q) * 0.25lf;\n"
                "  return c.bgr * c.g + vec3(c.st, float(wide.y)) + c.rba * float(wide.x);\n}\n");
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
}

TEST_CASE("probe --shader gives its reference the scene's index", "[probe][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      probeText(directory, "int f(int x) { return x + kMaterialOffset * 7 + kLightCount; }");
  INFO(result.out << result.err);
  CHECK(result.exitCode == 0);
}

TEST_CASE("probe --shader finds the planted mistake of the example", "[probe][gl]") {
  const TemporaryDirectory directory;
  const std::vector<std::string> words = {"probe",
                                          "--shader",
                                          kExamples + "schlick.glsl",
                                          "--reference",
                                          kExamples + "schlick.h",
                                          "--samples",
                                          "2000",
                                          "--json",
                                          "-"};
  const ProgramResult result = runProgram(directory, words);
  INFO(result.err);
  REQUIRE(result.exitCode == 1);
  const auto functions = result.json()["functions"];
  CHECK(functions[0]["verdict"] == "agrees");
  CHECK(functions[1]["function"] == "schlickFast(float, float)");
  CHECK(functions[1]["verdict"] == "differs");
  CHECK_FALSE(functions[1]["worst"].is_null());
}

TEST_CASE("probe --shader compares with a function of this project by name", "[probe][gl]") {
  const TemporaryDirectory directory;
  const std::string right =
      "// twintrace: a in [1, 2], b in [1, 2]\n"
      "float mine(vec3 a, vec3 b) { return dot(a, b); }";
  CHECK(probeText(directory, right, {"--reference", "dot3"}).exitCode == 0);
  const std::string wrong =
      "// twintrace: a in [1, 2], b in [1, 2]\n"
      "float mine(vec3 a, vec3 b) { return dot(a.xyy, b); }";
  CHECK(probeText(directory, wrong, {"--reference", "dot3"}).exitCode == 1);
  CHECK(probeText(directory, right, {"--reference", "length3"}).exitCode == 2);
  CHECK(probeText(directory, right, {"--reference", "dott3"}).exitCode == 2);
}

TEST_CASE("probe --shader maps mistakes to the user's line", "[probe][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult driver = probeText(directory, "float f(float x) {\n  return y;\n}\n");
  CHECK(driver.exitCode == 3);
  CHECK_THAT(driver.err, Contains("a.glsl:2"));
  const ProgramResult compiler =
      probeText(directory, "float f(float x) {\n  mat2 m = mat2(x);\n  return m[0][0];\n}\n");
  CHECK(compiler.exitCode == 2);
  CHECK_THAT(compiler.err, Contains("a.glsl:2:"));
}

TEST_CASE("probe --shader without its file or a compiler says so", "[probe][gl]") {
  const TemporaryDirectory directory;
  CHECK(runProgram(directory, {"probe", "--shader", "missing.glsl"}).exitCode == 4);
  writeBytes(directory.file("a.glsl"), "float f(float x) { return x; }");
  const ProgramResult none =
      RunningProgram(directory, {"probe", "--shader", "a.glsl"}, {{"CXX", "no-such-compiler"}})
          .wait();
  CHECK(none.exitCode == 3);
  CHECK_THAT(none.err, Contains("no-such-compiler"));
}

}  // namespace twintrace::test
