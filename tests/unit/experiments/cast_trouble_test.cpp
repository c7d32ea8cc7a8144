// What cast makes of a missing GL, of Ctrl-C, and of rays and cases that are no good.

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <sstream>
#include <thread>

#include "experiments/cli/command_line.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

namespace twintrace {
namespace {

using test::ProgramResult;
using test::RunningProgram;
using test::runProgram;
using test::TemporaryDirectory;

using Answer = nlohmann::json;

const std::string kTwoCases =
    "scene,ball\n"
    "sphere,s,0,0,0,1\n"
    "ray,through,0,0,-3,0,0,1,0,inf\n"
    "ray,beside,2,0,-3,0,0,1,0,inf\n";

/// cast --cases where EGL finds no driver.
ProgramResult castWithoutGl(const TemporaryDirectory& directory,
                            const std::vector<std::string>& more,
                            const std::string& cases = kTwoCases) {
  test::writeBytes(directory.file("cases.csv"), cases);
  std::vector<std::string> words = {"cast", "--cases", "cases.csv", "--gl", "egl"};
  words.insert(words.end(), more.begin(), more.end());
  return RunningProgram(directory, words, {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"}}).wait();
}

std::vector<std::string> engineNames(const Answer& report) {
  std::vector<std::string> names;
  for (const Answer& engine : report["engines"]) names.push_back(engine["engine"]);
  return names;
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

using Handler = void (*)(int);

Handler handlerOfInterrupts() {
  struct sigaction current {};
  sigaction(SIGINT, nullptr, &current);
  return current.sa_handler;
}

struct Interrupted {
  int exitCode = 0;
  std::string out;
};

/// Runs the program in this process and sends Ctrl-C as soon as it has a handler of its own.
Interrupted interruptAtOnce(const std::vector<std::string>& arguments) {
  const Handler before = handlerOfInterrupts();
  std::thread sender([before] {
    for (int i = 0; i < 60000 && handlerOfInterrupts() == before; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (handlerOfInterrupts() != before) std::raise(SIGINT);
  });
  std::ostringstream out;
  std::ostringstream err;
  const int exitCode = runCommandLine(arguments, {out, err});
  sender.join();
  return {exitCode, out.str()};
}

}  // namespace

TEST_CASE("cast --engine gpu without a GL exits with 3 and says what is missing", "[cast]") {
  const TemporaryDirectory directory;
  const ProgramResult result = castWithoutGl(directory, {"--engine", "gpu", "-o", "hits.csv"});
  CHECK(result.exitCode == 3);
  CHECK_THAT(result.err, Catch::StartsWith("twintrace: ") && Catch::Contains("egl"));
  CHECK(result.out.empty());
}

TEST_CASE("the jury goes on without a GL, and says so", "[cast]") {
  const TemporaryDirectory directory;
  const ProgramResult result = castWithoutGl(directory, {"--json", "j.json"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  CHECK_THAT(result.out, Catch::Contains("note: without gpu: ") &&
                             Catch::Contains("note: without gpu/report: "));
  const Answer json = Answer::parse(test::readBytes(directory.file("j.json")));
  CHECK(json["notes"].size() == 2);
  const Answer report = json["reports"][0];
  CHECK(engineNames(report) == std::vector<std::string>{"cpu", "cpu/report", "cpu64", "embree"});
  CHECK(report["gpu_cpu_compared"] == 0);
}

TEST_CASE("Ctrl-C ends cast with the judgement of the rays heard so far", "[cast]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("j.json");
  const Interrupted result =
      interruptAtOnce({"cast", "--family", "all", "--count", "4000000000", "--engine", "cpu",
                       "--quiet", "--json", file, "-o", directory.file("hits.csv")});
  CHECK(result.exitCode == 130);
  const Answer json = Answer::parse(test::readBytes(file));
  REQUIRE(json["reports"].size() == 1);
  const Answer report = json["reports"][0];
  CHECK(report["rays"] > 0);
  CHECK(report["rays"] < 4000000000u);
  CHECK(report["engines"][0]["asked"] == report["rays"]);
  CHECK_THAT(test::readBytes(directory.file("hits.csv")), Catch::StartsWith("scene,ray,engine"));
}

TEST_CASE("Ctrl-C ends cast of a file with the rays answered so far", "[cast]") {
  constexpr int kRays = 140000;  // more than two parts
  const TemporaryDirectory directory;
  std::string cases = "sphere,s,0,0,0,1\n";
  for (int i = 0; i < kRays; ++i) {  // the ball is at t = i
    cases += fmt::format("ray,{},0,0,{},0,0,1,0,inf\n", i, -1 - i);
  }
  const std::string path = directory.file("cases.csv");
  const std::string file = directory.file("j.json");
  const std::string hits = directory.file("hits.csv");
  test::writeBytes(path, cases);
  const std::vector<std::string> words = {"cast", "--cases", path, "--quiet", "--engine",
                                          "cpu",  "--json",  file, "-o",      hits};
  const Interrupted early = interruptAtOnce(words);
  CHECK(early.exitCode == 130);
  const Answer json = Answer::parse(test::readBytes(file));
  CHECK(json["rays"] < kRays);
  CHECK(json["rays"] > 0);
  CHECK(json["hits"] == json["rays"]);
  CHECK(countOf(test::readBytes(hits), ",cpu,s,") == json["rays"]);

  // Left alone it answers all, each under its own name.
  const ProgramResult whole = runProgram(directory, words);
  CHECK(whole.exitCode == 0);
  const std::string all = test::readBytes(hits);
  CHECK(countOf(all, ",cpu,s,") == kRays);
  for (const int i : {0, 65535, 65536, 131072, kRays - 1}) {
    CHECK_THAT(all, Catch::Contains(fmt::format("\n,{},cpu,s,{:a},", i, double(i))));
  }
}

TEST_CASE("cast reports every fault of cases at once, with line and column", "[cast]") {
  const TemporaryDirectory directory;
  test::writeBytes(directory.file("bad.csv"),
                   "scene,a\n"
                   "cone,c,1\n"               // no such record
                   "sphere,s,0,0,x,1\n"       // no number
                   "sphere,s,0,0,0,inf\n"     // not finite, and a name twice
                   "plane,,0,1,0,0,0,0\n"     // no name
                   "ray,r,0,0,0,0,0,1,0\n"    // too few values
                   "ray,r,0,0,0,0,0,1,0,1\n"  // none
                   "box,b,0,0,0,1,1,1\n"      // after a ray
                   "scene,a\n");              // a name twice
  const ProgramResult result = runProgram(directory, {"cast", "--cases", "bad.csv"});
  CHECK(result.exitCode == 2);
  CHECK(result.out.empty());
  for (const char* place :
       {":2:1:", ":3:14:", ":4:8:", ":4:16:", ":5:7:", ":6:1:", ":8:1:", ":9:7:"}) {
    CHECK_THAT(result.err, Catch::Contains("bad.csv" + std::string(place) + " found "));
  }
  CHECK(countOf(result.err, "bad.csv:") == 8);
}

TEST_CASE("cast reports every fault of rays at once, with line and column", "[cast]") {
  const TemporaryDirectory directory;
  test::writeBytes(directory.file("bad.csv"),
                   "ox,oy,oz,dx,dy,dz,tmin\n"
                   "0,1,3,0,0,-1,0\n"
                   "0,1,3,0,zero,-1,0,1e\n"
                   "0,1,3,0,0,-1,0,1\n");
  const ProgramResult result = runProgram(directory, {"cast", test::kCornell, "--rays", "bad.csv"});
  CHECK(result.exitCode == 2);
  CHECK(result.out.empty());
  for (const char* place : {":1:1:", ":2:1:", ":3:9:", ":3:19:"}) {
    CHECK_THAT(result.err, Catch::Contains("bad.csv" + std::string(place) + " found "));
  }
  CHECK(countOf(result.err, "bad.csv:") == 4);
}

TEST_CASE("a ray with a NaN anywhere misses before every engine and is counted", "[cast][gl]") {
  const TemporaryDirectory directory;
  std::string cases = "scene,inside\nbox,b,-9,-9,-9,9,9,9\nray,sound,0,0,0,0,0,1,0,inf\n";
  for (std::size_t i = 0; i < 8; ++i) {
    std::vector<std::string> numbers = {"0", "0", "0", "0", "0", "1", "0", "9"};
    numbers[i] = i % 2 == 0 ? "nan" : "-NaN";
    cases += "ray,nan-" + std::to_string(i);
    for (const std::string& number : numbers) cases += "," + number;
    cases += "\n";
  }
  test::writeBytes(directory.file("cases.csv"), cases);
  for (const std::string engine : {"cpu", "cpu64", "gpu", "embree", "exact"}) {
    const ProgramResult result =
        runProgram(directory, {"cast", "--cases", "cases.csv", "--engine", engine});
    INFO(engine << result.out);
    CHECK(result.exitCode == 0);
    CHECK_THAT(result.err, Catch::Contains("warning: cases.csv: 8 rays with a NaN, which miss"));
    CHECK_THAT(result.out, Catch::Contains("inside,sound," + engine + ",b,"));
    CHECK(countOf(result.out, engine + ",-1,") == 8);
  }
}

TEST_CASE("the jury counts rays with a NaN, and holds them against nobody", "[cast]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      castWithoutGl(directory, {"--json", "-"}, kTwoCases + "ray,nan,0,0,nan,0,0,1,0,inf\n");
  CHECK_THAT(result.err, Catch::Contains("warning: cases.csv: 1 ray with a NaN, which misses"));
  REQUIRE(result.exitCode == 0);
  const Answer report = result.json()["reports"][0];
  CHECK(report["rays"] == 3);
  CHECK(report["hits"] == 1);
  CHECK(report["nan_rays"] == 1);
  for (const Answer& engine : report["engines"]) {
    INFO(engine.dump());
    CHECK(engine["all"]["false_hits"] == 0);
    CHECK(engine["inexcusable"] == 0);
  }
}

}  // namespace twintrace
