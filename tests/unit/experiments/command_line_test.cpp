#include <filesystem>

#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;

TEST_CASE("The program without a command exits with 2", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(directory, {});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("twintrace: found no command, expected render, compare"));
}

TEST_CASE("The program's --help and --version exit with 0", "[cli]") {
  const TemporaryDirectory directory;
  CHECK(runProgram(directory, {"--help"}).exitCode == 0);
  CHECK(runProgram(directory, {"--version"}).out == "twintrace 0.1.0\n");
  const ProgramResult help = runProgram(directory, {"render", "--help"});
  CHECK(help.exitCode == 0);
  CHECK_THAT(help.out, Contains("--integrator"));
}

TEST_CASE("An unknown command exits with 2 and gets the nearest one", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(directory, {"compair", kCornell});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err,
             Contains("found command 'compair'") && Contains("(did you mean 'compare'?)"));
}

TEST_CASE("Commands of later versions are unknown", "[cli]") {
  const TemporaryDirectory directory;
  for (const char* command : {"preview", "view", "probe", "cast", "explain", "run"}) {
    INFO(command);
    CHECK(runProgram(directory, {command, kCornell}).exitCode == 2);
  }
}

TEST_CASE("An unknown option exits with 2 and gets the nearest one", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(directory, onCornell("render", {"--bounce", "3"}));
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err,
             Contains("found option '--bounce'") && Contains("(did you mean '--bounces'?)"));
}

TEST_CASE("A missing argument or value exits with 2", "[cli]") {
  const TemporaryDirectory directory;
  CHECK(runProgram(directory, {"render"}).exitCode == 2);
  CHECK(runProgram(directory, onCornell("render", {"--spp"})).exitCode == 2);
  CHECK(runProgram(directory, onCornell("render", {"more.toml"})).exitCode == 2);
}

TEST_CASE("A value out of its range exits with 2 and says what is allowed", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult noise = runProgram(directory, onCornell("render", {"--noise", "sin"}));
  CHECK(noise.exitCode == 2);
  CHECK(noise.err ==
        "twintrace: noise: found 'sin', expected pcg or sine (did you mean 'sine'?)\n");
  for (const char* spp : {"0", "-1", "x", "1e3", "99999999999"}) {
    INFO(spp);
    CHECK(runProgram(directory, onCornell("render", {"--spp", spp})).exitCode == 2);
  }
  CHECK(runProgram(directory, onCornell("render", {"--effects", "sphear"})).exitCode == 2);
  CHECK(runProgram(directory, onCornell("render", {"--shader-dir", "nowhere"})).exitCode == 2);
}

TEST_CASE("Options that exclude each other exit with 2", "[cli]") {
  const TemporaryDirectory directory;
  const std::vector<std::vector<std::string>> bad = {{"--precision", "double", "--lanes", "wide"},
                                                     {"--precision", "double", "--backend", "gpu"},
                                                     {"--hull", "embree", "--backend", "gpu"},
                                                     {"--first-sample", "3", "--passes", "2"},
                                                     {"--width", "100000", "--height", "100000"}};
  for (const auto& options : bad) {
    INFO(options[0] << " " << options[1]);
    CHECK(runProgram(directory, onCornell("render", options)).exitCode == 2);
  }
}

TEST_CASE("A scene that can't be read exits with 4", "[cli]") {
  const TemporaryDirectory directory;
  for (const char* command : {"render", "compare", "info"}) {
    const ProgramResult result = runProgram(directory, {command, "missing.toml"});
    CHECK(result.exitCode == 4);
    CHECK_THAT(result.err, Contains("missing.toml"));
  }
  CHECK(runProgram(directory, {"render", "."}).exitCode == 4);
}

TEST_CASE("A faulty scene exits with 2 and names the place of each fault", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("bad.toml"), "[film]\nwidth = -1\nhight = 3\n");
  const ProgramResult result = runProgram(directory, {"render", "bad.toml"});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("twintrace: bad.toml:2:") && Contains("twintrace: bad.toml:3:") &&
                             Contains("did you mean 'height'?"));
}

TEST_CASE("An image named by a scene that is none exits with 2", "[cli]") {
  const TemporaryDirectory directory;
  writeBytes(directory.file("sky.exr"), "this is no image");
  writeBytes(directory.file("sky.toml"), "[environment]\nimage = \"sky.exr\"\n");
  CHECK(runProgram(directory, {"render", "sky.toml"}).exitCode == 2);
}

TEST_CASE("An output that can't be written exits with 4 before the work", "[cli]") {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory.file("folder.exr"));
  const std::vector<std::vector<std::string>> bad = {{"-o", "nowhere/x.exr"},
                                                     {"-o", "folder.exr"},
                                                     {"--png", "nowhere/x.png"},
                                                     {"--film", "nowhere/f.film"},
                                                     {"--json", "nowhere/j.json"}};
  for (const auto& output : bad) {
    INFO(output[0] << " " << output[1]);
    // This many samples would take hours.
    auto options = output;
    options.insert(options.end(), {"--spp", "1000000000"});
    const ProgramResult result = runProgram(directory, onCornell("render", options));
    CHECK(result.exitCode == 4);
    CHECK_THAT(result.err, Contains("cannot be written"));
  }
  writeBytes(directory.file("file"), "");
  CHECK(runProgram(directory, onCornell("compare", {"--out", "file/x"})).exitCode == 4);
}

TEST_CASE("An output with a foreign ending exits with 2", "[cli]") {
  const TemporaryDirectory directory;
  CHECK(runProgram(directory, onCornell("render", {"-o", "x.jpg"})).exitCode == 2);
  CHECK(runProgram(directory, onCornell("render", {"--png", "x.exr"})).exitCode == 2);
  CHECK(runProgram(directory, onCornell("render", {"--film", "x.exr"})).exitCode == 2);
}

TEST_CASE("Two outputs with the same name exit with 2", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, onCornell("render", {"-o", "x.exr", "--json", "./x.exr"}));
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("'./x.exr' twice"));
  CHECK(runProgram(directory, onCornell("compare", {"--out", "d", "--json", "d/a.exr"})).exitCode ==
        2);
}

TEST_CASE("A device stays one when JSON is written to it", "[cli]") {
  const TemporaryDirectory directory;
  const std::vector<std::string> render = {"--spp", "1", "--json", "null"};
  std::filesystem::create_symlink("/dev/null", directory.file("null"));
  CHECK(runProgram(directory, onCornell("render", render)).exitCode == 0);
  CHECK(std::filesystem::is_symlink(directory.file("null")));
  CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("A missing provider exits with 3", "[cli]") {
  const TemporaryDirectory directory;
  RunningProgram program(directory, onCornell("render", {"--backend", "gpu", "--gl", "egl"}),
                         {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"}});
  const ProgramResult result = program.wait();
  CHECK(result.exitCode == 3);
  CHECK_THAT(result.err, Contains("twintrace: ") && Contains("egl"));
  CHECK_FALSE(std::filesystem::exists(directory.file("cornell.exr")));
}
