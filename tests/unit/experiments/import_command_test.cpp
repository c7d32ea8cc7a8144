#include <filesystem>

#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;

namespace {

const std::string kBalls =
    "v\nfrom 0 0 10\nat 0 0 0\nup 0 1 0\nangle 45\nresolution 16 16\n"
    "l 5 5 5\nf 1 0 0 1 1 20 0 1\ns 0 0 0 1\nc 0 0 0 1 0 2 0 0.5\n";

}  // namespace

TEST_CASE("import writes a scene beside its file that render takes", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("balls.nff"), kBalls);
  const ProgramResult result = runProgram(directory, {"import", "balls.nff"});
  CHECK(result.exitCode == 0);
  CHECK(result.out == "1 object, 1 sphere, 128 triangles, 1 light: balls.toml\n");
  CHECK_THAT(result.err,
             Contains("twintrace: warning: balls.nff: 1 cone or cylinder becomes a mesh "
                      "of 64 sides (chord error at most 0.0012)") &&
                 Contains("twintrace: warning: balls.nff: 1 material reflects more"));
  CHECK(runProgram(directory, {"render", "balls.toml", "--spp", "1"}).exitCode == 0);
  CHECK(std::filesystem::exists(directory.file("balls.exr")));
}

TEST_CASE("import --quiet prints no summary", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("balls.nff"), kBalls);
  CHECK(runProgram(directory, {"import", "balls.nff", "--quiet"}).out == "");
}

TEST_CASE("import without -o leaves a scene alone that is there", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("balls.nff"), kBalls);
  writeBytes(directory.file("balls.toml"), "mine");
  const ProgramResult result = runProgram(directory, {"import", "balls.nff"});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("found 'balls.toml' already there, expected -o"));
  CHECK(readBytes(directory.file("balls.toml")) == "mine");
  CHECK(runProgram(directory, {"import", "balls.nff", "-o", "balls.toml"}).exitCode == 0);
  CHECK(readBytes(directory.file("balls.toml")) != "mine");
}

TEST_CASE("import's faults have the exit codes of all commands", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("balls.nff"), kBalls);
  writeBytes(directory.file("bad.nff"), "s 1\n");
  const ProgramResult bad = runProgram(directory, {"import", "bad.nff"});
  CHECK(bad.exitCode == 2);
  CHECK_THAT(bad.err, Contains("twintrace: bad.nff:1:1: found"));
  CHECK_FALSE(std::filesystem::exists(directory.file("bad.toml")));
  CHECK(runProgram(directory, {"import"}).exitCode == 2);
  CHECK(runProgram(directory, {"import", "balls.nff", "-o", "balls.txt"}).exitCode == 2);
  CHECK(runProgram(directory, {"import", "missing.nff"}).exitCode == 4);
  CHECK(runProgram(directory, {"import", "missing.obj"}).exitCode == 4);
  CHECK(runProgram(directory, {"import", "balls.nff", "-o", "no/where.toml"}).exitCode == 4);
  // Before the work.
  CHECK(runProgram(directory, {"import", "bad.nff", "-o", "no/where.toml"}).exitCode == 4);
}

TEST_CASE("import writes nothing that is no scene", "[cli]") {
  const TemporaryDirectory directory;
  // Scene files are UTF-8.
  writeBytes(directory.file("b\xff.nff"), kBalls);
  const ProgramResult result = runProgram(directory, {"import", "b\xff.nff", "-o", "b.toml"});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("twintrace: b.toml:"));
  CHECK_FALSE(std::filesystem::exists(directory.file("b.toml")));
}
