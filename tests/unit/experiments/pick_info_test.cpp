#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;

TEST_CASE("pick names what a pixel's centre shows", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, {"pick", kCornell, "--pixel", "300,400", "--json", "-"});
  REQUIRE(result.exitCode == 0);
  const auto json = result.json();
  CHECK(json["hit"] == true);
  CHECK(json["object"] == "ball");
  CHECK(json["material"] == "mirror");
  CHECK(json["primitive"] == 0);
  // On the ball's surface, whose normal points away from its centre.
  const double centre[3] = {0.4, 0.35, 0.3};
  double distance = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double offset = json["position"][i].get<double>() - centre[i];
    distance += offset * offset;
    CHECK(json["normal"][i].get<double>() == Approx(offset / 0.35).margin(1e-5));
  }
  CHECK(std::sqrt(distance) == Approx(0.35));
}

TEST_CASE("pick says so where a pixel shows nothing", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("empty.toml"), "name = \"empty\"\n");
  const ProgramResult result = runProgram(directory, {"pick", "empty.toml", "--pixel", "0,0"});
  CHECK(result.exitCode == 0);
  CHECK(result.out == "pixel 0,0 shows no object\n");
}

TEST_CASE("pick refuses what is no pixel of the film", "[cli]") {
  const TemporaryDirectory directory;
  for (const char* pixel : {"512,0", "0,512", "-1,0", "3", "3,", "3,4,5", "x,y", ""}) {
    INFO(pixel);
    CHECK(runProgram(directory, {"pick", kCornell, "--pixel", pixel}).exitCode == 2);
  }
  CHECK(runProgram(directory, {"pick", kCornell}).exitCode == 2);
}

TEST_CASE("info describes program and machine", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(directory, {"info", "--json", "-"});
  REQUIRE(result.exitCode == 0);
  const auto json = result.json();
  CHECK(json["version"] == "0.1.0");
  CHECK(json["build"].contains("flags"));
  CHECK(json["instruction_sets"][0] == "sse2");
  CHECK(json["gl"].size() == 2);
  for (const auto& provider : json["gl"]) {
    CHECK((provider.contains("renderer") || provider.contains("reason")));
  }
  for (const char* library : {"embree", "openimageio", "tbb"}) {
    CHECK(json["libraries"].contains(library));
  }
  CHECK_FALSE(json.contains("scene"));
}

TEST_CASE("info of a scene counts it and accounts for each effect", "[cli]") {
  const TemporaryDirectory directory;
  const auto json = runProgram(directory, {"info", kCornell, "--json", "-"}).json();
  CHECK(json["scene"]["spheres"] == 1);
  CHECK(json["scene"]["primitives"] == 8);
  CHECK(json["scene"]["effects"]["mirror"]["compiled_in"] == true);
  CHECK(json["scene"]["effects"]["plane"]["compiled_in"] == false);
  CHECK(json["scene"]["effects"].size() == 17);
  CHECK(runProgram(directory, {"info", "--spp", "3"}).exitCode == 2);
}
