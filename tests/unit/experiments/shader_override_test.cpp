#include "experiments/shader_override.h"

#include "common/base/error.h"
#include "gpu/shader_source.h"
#include "tests/unit/experiments/program_run.h"

#include "tests/catch.h"

namespace twintrace::test {
namespace {

using Catch::Contains;

std::string shaderText(const std::string& name) {
  return ShaderLibrary().find(name).value().text;
}

/// The library's file with one expression changed, written into the directory.
std::string changedShader(const TemporaryDirectory& directory, const std::string& name,
                          const std::string& from, const std::string& to) {
  std::string text = shaderText(name);
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  const std::string path = directory.file("mine.glsl");
  writeBytes(path, text.replace(at, from.size(), to));
  return path;
}

const char* const kCosine = "(a.x * b.x + a.y * b.y) + a.z * b.z";

}  // namespace

TEST_CASE("readShaderOverride reads the file, with and without shaders/", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("a.glsl"), "text");
  const ShaderReplacement given =
      readShaderOverride("shaders/math.glsl=" + directory.file("a.glsl"), "");
  CHECK(given.shader == "math.glsl");
  CHECK(given.text == "text");
  CHECK(readShaderOverride("math.glsl=" + directory.file("a.glsl"), "").shader == "math.glsl");
}

TEST_CASE("readShaderOverride refuses what is no assignment", "[cli]") {
  for (const char* bad : {"", "math.glsl", "=a.glsl", "math.glsl="}) {
    INFO(bad);
    CHECK_THROWS_AS(readShaderOverride(bad, ""), UsageError);
  }
}

TEST_CASE("readShaderOverride suggests the nearest shader", "[cli]") {
  CHECK_THROWS_WITH(readShaderOverride("shaders/mth.glsl=/dev/null", ""),
                    Contains("did you mean 'math.glsl'?"));
}

TEST_CASE("readShaderOverride refuses a file that can't be read", "[cli]") {
  CHECK_THROWS_WITH(readShaderOverride("math.glsl=missing.glsl", ""), Contains("missing.glsl"));
  CHECK_THROWS_AS(readShaderOverride("math.glsl=/tmp", ""), UsageError);
}

TEST_CASE("compare finds an overridden shader", "[cli][gl]") {
  const TemporaryDirectory directory;
  const std::string path =
      changedShader(directory, "math.glsl", kCosine, "(a.x * b.x + a.y * b.y) - a.z * b.z");
  const auto arguments = onCornell(
      "compare", {"--spp", "1", "--override", "shaders/math.glsl=" + path, "--json", "-"});
  const ProgramResult result = runProgram(directory, arguments);
  CHECK(result.exitCode == 1);
  CHECK(result.json()["verdict"] == "different");
  CHECK(result.out.find("shader_overrides") != std::string::npos);
}

TEST_CASE("compare agrees when the override is the library's own text", "[cli][gl]") {
  const TemporaryDirectory directory;
  const std::string path = changedShader(directory, "math.glsl", kCosine, kCosine);
  const auto arguments =
      onCornell("compare", {"--spp", "1", "--override", "shaders/math.glsl=" + path});
  CHECK(runProgram(directory, arguments).exitCode == 0);
}

TEST_CASE("An arm of compare can have an override of its own", "[cli][gl]") {
  const TemporaryDirectory directory;
  const std::string path =
      changedShader(directory, "math.glsl", kCosine, "(a.x * b.x + a.y * b.y) - a.z * b.z");
  const auto arguments =
      onCornell("compare", {"--spp", "1", "--a", "backend=gpu", "--b",
                            "override=shaders/math.glsl=" + path + ",backend=gpu"});
  CHECK(runProgram(directory, arguments).exitCode == 1);
}

TEST_CASE("An override with a mistake in it is reported with its own file and line", "[cli][gl]") {
  const TemporaryDirectory directory;
  const std::string path = changedShader(directory, "math.glsl", kCosine, "missing");
  const auto arguments = onCornell(
      "render", {"--backend", "gpu", "--spp", "1", "--override", "shaders/math.glsl=" + path});
  const ProgramResult result = runProgram(directory, arguments);
  CHECK(result.exitCode == 3);
  CHECK_THAT(result.err, Contains(path + ":"));
}

TEST_CASE("render warns of an override that its program doesn't include", "[cli][gl]") {
  const TemporaryDirectory directory;
  const std::string path = changedShader(directory, "math.glsl", kCosine, kCosine);
  const auto arguments = onCornell("render", {"--backend", "gpu", "--maths", "native", "--spp", "1",
                                              "--override", "shaders/math.glsl=" + path});
  const ProgramResult result = runProgram(directory, arguments);
  CHECK(result.exitCode == 0);
  CHECK_THAT(result.err, Contains("does not include math.glsl"));
}

TEST_CASE("Overrides where nothing would read them exit with 2", "[cli]") {
  const TemporaryDirectory directory;
  const std::string path = changedShader(directory, "math.glsl", kCosine, kCosine);
  const std::string given = "shaders/math.glsl=" + path;
  CHECK(runProgram(directory, onCornell("render", {"--override", given})).exitCode == 2);
  CHECK(runProgram(directory, onCornell("compare", {"--override", given, "--b", "backend=cpu"}))
            .exitCode == 2);
  CHECK(runProgram(directory, onCornell("render", {"--override", "shaders/x.glsl=" + path}))
            .exitCode == 2);
}

TEST_CASE("Literal geometry and an override of the file that it replaces exclude each other",
          "[cli][gl]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("geometry.glsl");
  writeBytes(path, shaderText("geometry.glsl"));
  const std::vector<std::string> common = {
      "--backend", "gpu", "--spp", "1", "--override", "shaders/geometry.glsl=" + path};
  CHECK(runProgram(directory, onCornell("render", common)).exitCode == 0);
  std::vector<std::string> literal = common;
  literal.insert(literal.end(), {"--geometry", "literal"});
  CHECK(runProgram(directory, onCornell("render", literal)).exitCode == 2);
}

}  // namespace twintrace::test
