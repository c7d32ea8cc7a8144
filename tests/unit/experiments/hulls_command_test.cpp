#include <filesystem>

#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;

namespace {

constexpr const char* kBalls = R"toml(
name = "balls"
[film]
width = 24
height = 16
[camera]
eye = [0.0, 0.0, 6.0]
target = [0.0, 0.0, 0.0]
[materials.grey]
albedo = [0.5, 0.5, 0.5]
[[objects]]
name = "balls"
shape = "generate"
generator = "spheres"
size = 80
material = "grey"
)toml";

}  // namespace

TEST_CASE("hulls measures strategies and writes what it found", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("balls.toml"), kBalls);
  const ProgramResult result =
      runProgram(directory, {"hulls", "balls.toml", "--strategies", "none,aabb,bvh,bvh8", "--engines",
                             "cpu,cpu64,embree", "--repeats", "2", "--out", "found", "--heat", "--quiet",
                             "--json", "-"});
  REQUIRE(result.exitCode == 0);
  const auto json = result.json();
  // 4 strategies in float, 3 in double and the witness; 3 kinds of rays, 2 repeats.
  CHECK(json["benchmarks"].size() == (4 + 3 + 1) * 3 * 2);
  for (const auto& run : json["benchmarks"]) {
    CAPTURE(run["name"]);
    CHECK(run["differing"] == 0);
    CHECK(run["real_time"] > 0.0);
    if (run["name"] == "balls/bvh/primary/cpu") {
      CHECK(run["rays"] == 24 * 16);
      CHECK(run["primitives"] == 80);
      CHECK(run["hits"] > 10);
      CHECK(run["primitive_tests"] < 80 * 24 * 16);
    }
  }
  for (const char* name : {"hulls.json", "hulls.csv", "hulls.html", "balls-none.png", "balls-bvh8.png"}) {
    CAPTURE(name);
    CHECK(std::filesystem::exists(directory.file(std::string("found/") + name)));
  }
}

TEST_CASE("hulls says what it does not know", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("balls.toml"), kBalls);
  const auto fault = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"hulls", "balls.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramResult result = runProgram(directory, arguments);
    CHECK(result.exitCode == 2);
    return result.err;
  };
  CHECK_THAT(fault({"--strategies", "bhv"}), Contains("strategies: found 'bhv'") && Contains("(did you mean 'bvh'?)"));
  CHECK_THAT(fault({"--rays", "shadows"}), Contains("rays: found 'shadows'") && Contains("(did you mean 'shadow'?)"));
  CHECK_THAT(fault({"--engines", "fpga"}), Contains("engines: found 'fpga', expected cpu, cpu64, gpu"));
  CHECK_THAT(fault({"--heat"}), Contains("found --heat without --out"));
  CHECK(runProgram(directory, {"hulls"}).exitCode == 2);
  // A directory where a file is.
  CHECK(runProgram(directory, {"hulls", "balls.toml", "--out", "balls.toml"}).exitCode == 4);
}
