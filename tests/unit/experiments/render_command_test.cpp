#include <filesystem>

#include "common/film/image_io.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;
using twintrace::ExrContent;
using twintrace::readExr;

TEST_CASE("render without -o writes NAME.exr and NAME.png into the working directory", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(directory, onCornell("render", {"--spp", "4"}));
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.out, Contains("cornell.exr, cornell.png"));
  const ExrContent content = readExr(directory.file("cornell.exr"));
  CHECK(content.image.width == 16);
  CHECK(std::filesystem::exists(directory.file("cornell.png")));
}

TEST_CASE("render -o writes only what it is told", "[cli]") {
  const TemporaryDirectory directory;
  REQUIRE(runProgram(directory, onCornell("render", {"--spp", "4", "-o", "x.exr"})).exitCode == 0);
  CHECK(std::filesystem::exists(directory.file("x.exr")));
  CHECK_FALSE(std::filesystem::exists(directory.file("x.png")));
  CHECK_FALSE(std::filesystem::exists(directory.file("cornell.png")));
}

TEST_CASE("render --json - writes JSON and nothing else to standard output", "[cli]") {
  const TemporaryDirectory directory;
  const auto json =
      runProgram(directory,
                 onCornell("render", {"--spp", "8", "--passes", "4", "--seed", "7", "--json", "-"}))
          .json();
  CHECK(json["samples_per_pixel"] == 8);
  CHECK(json["samples"] == "0-7");
  CHECK(json["frames"] == 2);
  CHECK(json["stopped_by"] == "samples");
  CHECK(json["seconds"] > 0);
  CHECK(json["bad_frames"]["count"] == 0);
  CHECK(json["provenance"]["arm"]["options"]["seed"] == "7");
  CHECK(json["provenance"]["arm"]["options"]["bounces"] == "6");
  CHECK(json["provenance"]["version"] == "0.1.0");
  CHECK(json["provenance"].contains("cpu"));
}

TEST_CASE("render --quiet prints nothing", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, onCornell("render", {"--spp", "4", "--quiet"}));
  CHECK(result.exitCode == 0);
  CHECK(result.out.empty());
  CHECK(result.err.empty());
}

TEST_CASE("Options override the scene's", "[cli]") {
  const TemporaryDirectory directory;
  REQUIRE(runProgram(directory, onCornell("render", {"--spp", "4", "--bounces", "2"})).exitCode ==
          0);
  const auto metadata = readExr(directory.file("cornell.exr")).metadata;
  CHECK(metadata.at("bounces") == "2");
  CHECK(metadata.at("integrator") == "path");
}

TEST_CASE("EXR metadata holds only what determines the bits", "[cli]") {
  const TemporaryDirectory directory;
  const auto exrOf = [&](const std::vector<std::string>& options) {
    auto all = options;
    all.insert(all.end(), {"--spp", "4", "-o", "x.exr"});
    REQUIRE(runProgram(directory, onCornell("render", all)).exitCode == 0);
    return readBytes(directory.file("x.exr"));
  };
  const std::string plain = exrOf({});
  CHECK(exrOf({"--lanes", "scalar"}) == plain);
  CHECK(exrOf({"--threads", "1"}) == plain);
  CHECK(exrOf({"--effects", "all"}) == plain);
  CHECK(exrOf({"--seed", "2"}) != plain);
  CHECK(exrOf({"--maths", "native"}) != plain);
}

TEST_CASE("render --time stops after the time, whatever spp the scene has", "[cli]") {
  const TemporaryDirectory directory;
  const std::string scene = directory.file("one_sample.toml");
  writeBytes(scene, "[film]\nwidth = 4\nheight = 4\n[render]\nspp = 1\n");
  const auto json =
      runProgram(directory, {"render", scene, "--time", "0.3", "--json", "-"}).json();
  CHECK(json["stopped_by"] == "time");
  CHECK(json["seconds"] >= 0.3);
  CHECK(json["samples_per_pixel"] > 1);
}

TEST_CASE("render --spp limits the samples of a run with a stop rule", "[cli]") {
  const TemporaryDirectory directory;
  const auto json =
      runProgram(directory, onCornell("render", {"--time", "100", "--spp", "32", "--json", "-"}))
          .json();
  CHECK(json["stopped_by"] == "samples");
  CHECK(json["samples_per_pixel"] == 32);
}

TEST_CASE("render --target-error stops at the estimated error", "[cli]") {
  const TemporaryDirectory directory;
  const auto json =
      runProgram(directory, onCornell("render", {"--target-error", "0.01", "--json", "-"})).json();
  CHECK(json["stopped_by"] == "target-error");
  CHECK(json["relative_standard_error"] <= 0.01);
}

TEST_CASE("Two runs split by --first-sample merge to the bytes of one run", "[cli]") {
  const TemporaryDirectory directory;
  const auto render = [&](const char* name, const char* first, const char* spp) {
    const std::string base(name);
    REQUIRE(runProgram(directory,
                       onCornell("render", {"--passes", "8", "--first-sample", first, "--spp", spp,
                                            "--film", base + ".film", "-o", base + ".exr"}))
                .exitCode == 0);
  };
  render("a", "0", "24");
  render("b", "24", "16");
  render("whole", "0", "40");
  REQUIRE(runProgram(directory, {"merge", "b.film", "a.film", "-o", "m.exr"}).exitCode == 0);
  REQUIRE(runProgram(directory, {"merge", "a.film", "b.film", "-o", "m.film"}).exitCode == 0);
  CHECK(readBytes(directory.file("m.exr")) == readBytes(directory.file("whole.exr")));
  CHECK(readBytes(directory.file("m.film")) == readBytes(directory.file("whole.film")));
}

TEST_CASE("merge refuses films that overlap or don't belong together", "[cli]") {
  const TemporaryDirectory directory;
  const auto render = [&](const char* film, const char* seed) {
    REQUIRE(
        runProgram(directory, onCornell("render", {"--spp", "4", "--seed", seed, "--film", film}))
            .exitCode == 0);
  };
  render("a.film", "1");
  render("b.film", "2");
  const ProgramResult overlap = runProgram(directory, {"merge", "a.film", "a.film", "-o", "m.exr"});
  CHECK(overlap.exitCode == 2);
  CHECK_THAT(overlap.err, Contains("a.film: ") && Contains("overlap"));
  const ProgramResult foreign = runProgram(directory, {"merge", "a.film", "b.film", "-o", "m.exr"});
  CHECK(foreign.exitCode == 2);
  CHECK_THAT(foreign.err, Contains("seed = 2"));
  CHECK(runProgram(directory, {"merge", "a.film", "none.film", "-o", "m.exr"}).exitCode == 4);
  CHECK(runProgram(directory, {"merge", "a.film", "-o", "m.png"}).exitCode == 2);
  CHECK(runProgram(directory, {"merge", "a.film", "-o", "nowhere/m.exr"}).exitCode == 4);
}
