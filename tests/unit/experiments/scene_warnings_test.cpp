#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;

namespace {

const std::string kScene =
    "[film]\nwidth = 8\nheight = 8\n[render]\nspp = 1\n[materials.white]\nalbedo = [0.5, 0.5, "
    "0.5]\n"
    "[[objects]]\nshape = \"mesh\"\nfile = \"a.obj\"\nmaterial = \"white\"\n";
const std::string kMesh = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
const std::string kWarning = "twintrace: warning: a.obj: 1 triangle without area is left out\n";

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

ProgramResult runOn(const std::string& mesh, const std::vector<std::string>& arguments) {
  const TemporaryDirectory directory;
  writeBytes(directory.file("s.toml"), kScene);
  writeBytes(directory.file("a.obj"), mesh);
  writeBytes(directory.file("rays.csv"), "ox,oy,oz,dx,dy,dz,tmin,tmax\n0,0,5,0,0,-1,0,inf\n");
  return runProgram(directory, arguments);
}

}  // namespace

TEST_CASE("Every command that reads a scene warns once of what a mesh leaves out", "[cli]") {
  const std::vector<std::vector<std::string>> commands = {
      {"render", "s.toml"},
      {"render", "s.toml", "--quiet"},
      {"compare", "s.toml", "--a", "lanes=scalar", "--b", "backend=cpu,lanes=wide"},
      {"explain", "s.toml", "--pixel", "4,4", "--sample", "0", "--a", "backend=cpu", "--b",
       "backend=cpu,precision=double"},
      {"pick", "s.toml", "--pixel", "4,4"},
      {"info", "s.toml"},
      {"cast", "s.toml", "--rays", "rays.csv", "--engine", "cpu"}};
  for (const auto& command : commands) {
    const ProgramResult result = runOn(kMesh + "f 1 1 2\n", command);
    INFO(command[0] << ": " << result.err);
    CHECK(result.exitCode <= 1);
    CHECK(countOf(result.err, kWarning) == 1);
  }
}

TEST_CASE("Nothing is warned of where a mesh is whole", "[cli]") {
  const ProgramResult result = runOn(kMesh, {"render", "s.toml", "--quiet"});
  CHECK(result.exitCode == 0);
  CHECK(result.err.empty());
}

TEST_CASE("What is wrong with a mesh that a scene names exits with 2", "[cli]") {
  for (const std::string& mesh : {std::string(""), std::string("v 0 0 0\n"), kMesh + "f 1 2 9\n",
                                  "v nan 0 0\n" + kMesh, std::string("\x7f\0ELF rubbish", 12)}) {
    const ProgramResult result = runOn(mesh, {"render", "s.toml"});
    INFO(result.err);
    CHECK(result.exitCode == 2);
    CHECK_THAT(result.err, Contains("s.toml:8:1: found "));
  }
  const TemporaryDirectory directory;
  writeBytes(directory.file("s.toml"), kScene);
  const ProgramResult missing = runProgram(directory, {"render", "s.toml"});
  CHECK(missing.exitCode == 2);
  CHECK_THAT(missing.err, Contains("s.toml:10:8: found no file 'a.obj'"));
}
