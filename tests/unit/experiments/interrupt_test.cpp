#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "common/film/image_io.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;

namespace {

/// Runs a command that would take hours, sends Ctrl-C after the first sign of progress.
ProgramResult interruptWhileRendering(const TemporaryDirectory& directory,
                                      const std::vector<std::string>& arguments) {
  RunningProgram program(directory, arguments);
  // A plain progress line comes after 2 seconds; 60 are for a machine under load.
  for (int i = 0; i < 600; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (!readBytes(directory.file("stderr.txt")).empty()) break;
  }
  kill(program.pid(), SIGINT);
  return program.wait();
}

}  // namespace

TEST_CASE("Ctrl-C ends render after the frame under way and writes what is done", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = interruptWhileRendering(
      directory,
      onCornell("render", {"--spp", "1000000000", "--passes", "64", "--film", "x.film"}));
  INFO(result.err);
  CHECK(result.exitCode == 130);
  const twintrace::ExrContent content = twintrace::readExr(directory.file("cornell.exr"));
  CHECK(content.count[0] >= 1);
  CHECK(content.metadata.at("samples") == "0-" + std::to_string(int(content.count[0]) * 64 - 1));
  CHECK(std::filesystem::exists(directory.file("cornell.png")));
  CHECK(std::filesystem::exists(directory.file("x.film")));
}

TEST_CASE("Ctrl-C ends compare with the verdict on what is done", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = interruptWhileRendering(
      directory, onCornell("compare", {"--spp", "1000000000", "--b", "backend=cpu,lanes=scalar",
                                       "--out", "out", "--json", "j.json"}));
  INFO(result.err);
  CHECK(result.exitCode == 130);
  const auto json = nlohmann::json::parse(readBytes(directory.file("j.json")));
  CHECK(json["verdict"] == "identical");
  CHECK(json["arms"]["a"]["stopped_by"] == "interrupt");
  CHECK(json["arms"]["a"]["samples"] == json["arms"]["b"]["samples"]);
  CHECK(std::filesystem::exists(directory.file("out/sheet.png")));
}
