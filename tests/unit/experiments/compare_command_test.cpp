#include <filesystem>

#include "common/film/image_io.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

using namespace twintrace::test;
using Catch::Matchers::Contains;
using twintrace::ExrContent;
using twintrace::Image;

namespace {

std::vector<std::string> cpuArms(const std::string& a, const std::string& b,
                                 const std::vector<std::string>& more = {}) {
  std::vector<std::string> options = {"--backend", "cpu", "--spp", "64",  "--json",
                                      "-",         "--a", a,       "--b", b};
  options.insert(options.end(), more.begin(), more.end());
  return onCornell("compare", options);
}

Image constantImage(int width, int height, float value) {
  Image image(width, height);
  image.rgb.assign(image.rgb.size(), value);
  return image;
}

void writePicture(const TemporaryDirectory& directory, const std::string& name,
                  const Image& image) {
  ExrContent content;
  content.image = image;
  writeExr(directory.file(name), content);
}

const std::vector<std::string> kContractKeys = {
    "verdict",   "pixels",           "differing_pixels", "max_ulp",
    "rmse",      "relmse",           "mean_a",           "mean_b",
    "seconds_a", "seconds_b",        "family_alpha",     "equivalence",
    "classes",   "first_difference", "provenance",       "z_rejected_fraction"};

}  // namespace

TEST_CASE("compare of equal arms is identical, exits with 0 and writes equal files", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, cpuArms("lanes=wide", "lanes=scalar", {"--out", "deep/out"}));
  REQUIRE(result.exitCode == 0);
  const auto json = result.json();
  for (const std::string& key : kContractKeys) {
    INFO(key);
    CHECK(json.contains(key));
  }
  CHECK(json["verdict"] == "identical");
  CHECK(json["pixels"] == 256);
  CHECK(json["differing_pixels"] == 0);
  CHECK(json["max_ulp"] == 0);
  CHECK(json["first_difference"].is_null());
  CHECK(json["mean_a"].size() == 3);
  CHECK(json["equivalence"]["bound"] == 0.005);
  CHECK(json["seconds_a"] > 0);
  CHECK(json["provenance"]["a"]["options"]["lanes"] == "wide");
  CHECK(json["provenance"]["b"]["options"]["lanes"] == "scalar");
  for (const char* name : {"a.png", "b.png", "diff.exr", "sheet.png"}) {
    INFO(name);
    CHECK(std::filesystem::file_size(directory.file(std::string("deep/out/") + name)) > 0);
  }
  CHECK(readBytes(directory.file("deep/out/a.exr")) == readBytes(directory.file("deep/out/b.exr")));
  CHECK(readBytes(directory.file("deep/out/compare.json")) == result.out);
}

TEST_CASE("compare writes what it can if one output fails", "[cli]") {
  const TemporaryDirectory directory;
  std::filesystem::create_directories(directory.file("out/a.exr/full"));
  std::vector<std::string> words = cpuArms("lanes=wide", "lanes=scalar", {"--out", "out"});
  words.erase(std::find(words.begin(), words.end(), "--json"),
              std::find(words.begin(), words.end(), "--a"));
  const ProgramResult result = runProgram(directory, words);
  CHECK(result.exitCode == 4);
  CHECK_THAT(result.err, Contains("out/a.exr: cannot be written"));
  CHECK_THAT(result.out, Contains("verdict: identical"));
  for (const char* name : {"compare.json", "b.exr", "sheet.png"}) {
    INFO(name);
    CHECK(std::filesystem::exists(directory.file(std::string("out/") + name)));
  }
}

TEST_CASE("compare takes the CPU for a and the GPU for b", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, onCornell("compare", {"--spp", "16", "--json", "-"}));
  CHECK(result.exitCode == 0);
  const auto json = result.json();
  CHECK(json["verdict"] == "identical");
  CHECK(json["provenance"]["a"]["options"]["backend"] == "cpu");
  CHECK(json["provenance"]["b"]["options"]["backend"] == "gpu");
  CHECK(json["provenance"]["b"]["ran"].contains("gl_renderer"));
}

TEST_CASE("compare of float and double is different and finds the first sample", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(
      directory, cpuArms("precision=float", "precision=double", {"--passes", "1", "--out", "out"}));
  CHECK(result.exitCode == 1);
  const auto json = result.json();
  CHECK(json["verdict"] == "different");
  CHECK(json["differing_pixels"] > 0);
  CHECK(json["max_ulp"] > 0);
  CHECK(json["classes"].contains("rounding"));
  const auto first = json["first_difference"];
  REQUIRE(first["sample"].is_number());
  CHECK(first["a"] != first["b"]);

  // The samples before it agree at that pixel, the sample itself doesn't.
  const auto differs = [&](int firstSample, int samples) {
    runProgram(directory, cpuArms("precision=float", "precision=double",
                                  {"--passes", "1", "--out", "part", "--first-sample",
                                   std::to_string(firstSample), "--spp", std::to_string(samples)}));
    const Image a = twintrace::readExr(directory.file("part/a.exr")).image;
    const Image b = twintrace::readExr(directory.file("part/b.exr")).image;
    const std::size_t i = 3 * (first["y"].get<std::size_t>() * 16 + first["x"].get<std::size_t>());
    return a.rgb[i] != b.rgb[i] || a.rgb[i + 1] != b.rgb[i + 1] || a.rgb[i + 2] != b.rgb[i + 2];
  };
  const int sample = first["sample"];
  CHECK(differs(sample, 1));
  if (sample > 0) CHECK_FALSE(differs(0, sample));

  const ExrContent difference = twintrace::readExr(directory.file("out/diff.exr"));
  std::vector<std::string> names;
  for (const auto& channel : difference.extra) names.push_back(channel.name);
  CHECK_THAT(names, Catch::Matchers::UnorderedEquals(
                        std::vector<std::string>{"ulp", "diverge.bounce", "z.R", "z.G", "z.B"}));
}

TEST_CASE("compare of unequal seeds is equivalent within a bound", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(
      directory,
      cpuArms("seed=1", "seed=2", {"--spp", "4096", "--passes", "16", "--bound", "0.1"}));
  CHECK(result.exitCode == 0);
  const auto json = result.json();
  CHECK(json["verdict"] == "equivalent");
  CHECK(json["paired"] == false);
  CHECK(json["equivalence"]["p"] <= 0.001);
  CHECK(json["family"]["rejected"] == 0);
}

TEST_CASE("compare of unequal seeds with too few samples is inconclusive", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, cpuArms("seed=1", "seed=2", {"--bound", "0.0001"}));
  CHECK(result.exitCode == 1);
  CHECK(result.json()["verdict"] == "inconclusive");
}

TEST_CASE("compare of unequal seeds and unequal light is different", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult result =
      runProgram(directory, cpuArms("seed=1", "seed=2,bounces=1", {"--spp", "1024"}));
  CHECK(result.exitCode == 1);
  CHECK(result.json()["verdict"] == "different");
}

TEST_CASE("compare gives unpaired arms their 32 batches and says so", "[cli]") {
  const TemporaryDirectory directory;
  const auto json = runProgram(directory, cpuArms("seed=1,spp=8", "seed=2,passes=16")).json();
  CHECK(json["arms"]["a"]["samples"] == "0-31");
  CHECK(json["arms"]["b"]["samples"] == "0-63");
  CHECK(json["arms"]["b"]["passes"] == 2);
  CHECK(json["notes"].size() == 3);
}

TEST_CASE("A paired compare with a time limit keeps the samples of both arms equal", "[cli]") {
  const TemporaryDirectory directory;
  const auto json = runProgram(directory, onCornell("compare", {"--b", "backend=cpu,lanes=scalar",
                                                                "--time", "0.2", "--json", "-"}))
                        .json();
  CHECK(json["verdict"] == "identical");
  CHECK(json["arms"]["a"]["samples"] == json["arms"]["b"]["samples"]);
  CHECK(json["arms"]["a"]["stopped_by"] == "time");
}

TEST_CASE("A stop rule of one arm lifts the limit of both paired arms", "[cli]") {
  const TemporaryDirectory directory;
  const auto json =
      runProgram(directory, onCornell("compare", {"--a", "backend=cpu,time=0.3", "--b",
                                                  "backend=cpu,lanes=scalar", "--json", "-"}))
          .json();
  CHECK(json["paired"] == true);
  CHECK(json["verdict"] == "identical");
  CHECK(json["arms"]["a"]["samples"] == json["arms"]["b"]["samples"]);
  CHECK(json["arms"]["a"]["samples"] != "0-63");
  CHECK(json["arms"]["a"]["stopped_by"] == "time");
}

TEST_CASE("Arms with unequal passes and a time limit are no false difference", "[cli]") {
  const TemporaryDirectory directory;
  const auto json =
      runProgram(directory, onCornell("compare", {"--backend", "cpu", "--a", "passes=2", "--b",
                                                  "passes=8", "--time", "0.2", "--json", "-"}))
          .json();
  CHECK(json["paired"] == false);
  CHECK(json["verdict"] != "different");
  CHECK_THAT(json["notes"][0].get<std::string>(), Contains("passes differ (2 and 8)"));
}

TEST_CASE("compare --repeats times each arm as often and reports the fastest", "[cli]") {
  const TemporaryDirectory directory;
  const auto json =
      runProgram(directory, cpuArms("lanes=wide", "lanes=scalar", {"--repeats", "3"})).json();
  REQUIRE(json["arms"]["a"]["seconds"].size() == 3);
  double fastest = 1e9;
  for (const auto& seconds : json["arms"]["a"]["seconds"]) {
    fastest = std::min(fastest, seconds.get<double>());
  }
  CHECK(json["seconds_a"] == fastest);
}

TEST_CASE("compare names the arm with a wrong option", "[cli]") {
  const TemporaryDirectory directory;
  const ProgramResult unknown =
      runProgram(directory, onCornell("compare", {"--a", "backend=cpu", "--b", "sed=3"}));
  CHECK(unknown.exitCode == 2);
  CHECK_THAT(unknown.err, Contains("--b: found option 'sed'") && Contains("did you mean 'seed'?"));
  CHECK(runProgram(directory, onCornell("compare", {"--a", "cpu"})).exitCode == 2);
  const ProgramResult sizes = runProgram(directory, onCornell("compare", {"--b", "width=8"}));
  CHECK(sizes.exitCode == 2);
  CHECK_THAT(sizes.err, Contains("16x16") && Contains("8x16"));
  CHECK(runProgram(directory, onCornell("compare", {"--alpha", "2"})).exitCode == 2);
  CHECK(runProgram(directory, onCornell("compare", {"--repeats", "0"})).exitCode == 2);
}

TEST_CASE("Two pictures of the same samples are compared by bits", "[cli]") {
  const TemporaryDirectory directory;
  REQUIRE(runProgram(directory, onCornell("render", {"--spp", "8", "-o", "a.exr"})).exitCode == 0);
  REQUIRE(runProgram(directory,
                     onCornell("render", {"--spp", "8", "-o", "b.exr", "--precision", "double"}))
              .exitCode == 0);
  const ProgramResult same = runProgram(directory, {"compare", "a.exr", "a.exr", "--json", "-"});
  CHECK(same.exitCode == 0);
  CHECK(same.json()["verdict"] == "identical");
  for (const std::string& key : kContractKeys) CHECK(same.json().contains(key));
  const ProgramResult other = runProgram(directory, {"compare", "a.exr", "b.exr", "--json", "-"});
  CHECK(other.exitCode == 1);
  CHECK(other.json()["verdict"] == "different");
  CHECK(other.json()["paired"] == true);
}

TEST_CASE("Two pictures of unequal seeds are tested by their variance channels", "[cli]") {
  const TemporaryDirectory directory;
  for (const char* seed : {"1", "2"}) {
    REQUIRE(runProgram(directory, onCornell("render", {"--spp", "4096", "--seed", seed, "-o",
                                                       std::string(seed) + ".exr"}))
                .exitCode == 0);
  }
  const ProgramResult result =
      runProgram(directory, {"compare", "1.exr", "2.exr", "--bound", "0.1", "--json", "-"});
  CHECK(result.exitCode == 0);
  CHECK(result.json()["verdict"] == "equivalent");
  CHECK(result.json()["paired"] == false);
}

TEST_CASE("compare notes a seed that unpaired pictures share", "[cli]") {
  const TemporaryDirectory directory;
  const auto arms = runProgram(directory, cpuArms("spp=64", "spp=128")).json();
  CHECK(arms["paired"] == false);
  CHECK_THAT(arms["notes"].back().get<std::string>(), Contains("share their seed"));
  for (const char* spp : {"32", "64"}) {
    REQUIRE(
        runProgram(directory, onCornell("render", {"--spp", spp, "-o", std::string(spp) + ".exr"}))
            .exitCode == 0);
  }
  const auto files = runProgram(directory, {"compare", "32.exr", "64.exr", "--json", "-"}).json();
  CHECK(files["paired"] == false);
  CHECK_THAT(files["notes"].back().get<std::string>(), Contains("share their seed"));
}

TEST_CASE("Pictures from elsewhere need errors unless all bits are equal", "[cli]") {
  const TemporaryDirectory directory;
  writePicture(directory, "a.exr", constantImage(16, 16, 0.5f));
  writePicture(directory, "near.exr", constantImage(16, 16, 0.5005f));
  writePicture(directory, "far.exr", constantImage(16, 16, 0.9f));
  writePicture(directory, "error.exr", constantImage(16, 16, 0.001f));
  const auto compare = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "compare");
    return runProgram(directory, words);
  };
  CHECK(compare({"a.exr", "a.exr"}).exitCode == 0);
  const ProgramResult without = compare({"a.exr", "near.exr", "--json", "-", "--out", "out"});
  CHECK(without.exitCode == 1);
  CHECK(without.json()["verdict"] == "inconclusive");
  CHECK(without.json()["family"].is_null());
  CHECK_THAT(without.json()["notes"][0].get<std::string>(),
             Contains("Variance.R") && Contains("--stderr-a"));
  CHECK(std::filesystem::exists(directory.file("out/sheet.png")));
  const std::vector<std::string> errors = {"--stderr-a", "error.exr", "--stderr-b",
                                           "error.exr",  "--json",    "-"};
  std::vector<std::string> near = {"a.exr", "near.exr"};
  near.insert(near.end(), errors.begin(), errors.end());
  CHECK(compare(near).json()["verdict"] == "equivalent");
  std::vector<std::string> far = {"a.exr", "far.exr"};
  far.insert(far.end(), errors.begin(), errors.end());
  CHECK(compare(far).exitCode == 1);
}

TEST_CASE("Two pictures of unequal sizes exit with 2 and name both", "[cli]") {
  const TemporaryDirectory directory;
  writePicture(directory, "a.exr", constantImage(16, 16, 0.5f));
  writePicture(directory, "b.exr", constantImage(8, 4, 0.5f));
  const ProgramResult result = runProgram(directory, {"compare", "a.exr", "b.exr"});
  CHECK(result.exitCode == 2);
  CHECK_THAT(result.err, Contains("16x16 (a.exr)") && Contains("8x4 (b.exr)"));
}

TEST_CASE("compare refuses inputs and options that don't go together", "[cli]") {
  const TemporaryDirectory directory;
  writePicture(directory, "a.exr", constantImage(2, 2, 0.5f));
  CHECK(runProgram(directory, {"compare", "a.exr", "a.exr", "--spp", "3"}).exitCode == 2);
  CHECK(runProgram(directory, {"compare", "a.exr", "a.exr", "a.exr"}).exitCode == 2);
  CHECK(runProgram(directory, {"compare", kCornell, "a.exr"}).exitCode == 2);
  CHECK(runProgram(directory, {"compare", kCornell, "--stderr-a", "a.exr"}).exitCode == 2);
  CHECK(runProgram(directory, {"compare", "a.exr", "none.exr"}).exitCode == 4);
}

TEST_CASE("JSON stays valid where a picture has NaN", "[cli]") {
  const TemporaryDirectory directory;
  Image image = constantImage(2, 2, 0.5f);
  writePicture(directory, "a.exr", image);
  image.rgb[3] = std::numeric_limits<float>::quiet_NaN();
  writePicture(directory, "b.exr", image);
  const ProgramResult same = runProgram(directory, {"compare", "b.exr", "b.exr", "--json", "-"});
  CHECK(same.exitCode == 0);
  CHECK(same.json()["non_finite_values"] == 1);
  writePicture(directory, "e.exr", constantImage(2, 2, 0.1f));
  const ProgramResult other = runProgram(
      directory,
      {"compare", "a.exr", "b.exr", "--stderr-a", "e.exr", "--stderr-b", "e.exr", "--json", "-"});
  CHECK(other.json()["first_difference"]["b"][0].is_null());
}
