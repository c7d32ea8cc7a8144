#include <cmath>
#include <cstring>

#include "common/film/image_io.h"
#include "gpu/shader_source.h"
#include "tests/catch.h"
#include "tests/unit/experiments/program_run.h"

namespace twintrace::test {
namespace {

/// All of its pixels are lit.
const std::string kLit = TWINTRACE_SOURCE_DIR "/tests/unit/experiments/explain/ball.toml";

constexpr int kRoundingColumn = 3;
constexpr int kBranchColumn = 7;

/// path_state.glsl with two faults, as a value of --override: in one column of pixels the
/// throughput is slightly off; in another, except for its first 5 rows, the path has ended before
/// it began.
std::string faultyStart(const TemporaryDirectory& directory) {
  const std::string from = "PathState(key, ray, vec3(1.0f), vec3(0.0f), 0, true);";
  std::string text = ShaderLibrary().find("path_state.glsl").value().text;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(),
               "PathState(key, ray, vec3(x == " + std::to_string(kRoundingColumn) +
                   " ? 0.99999f : 1.0f), vec3(0.0f), 0, x != " + std::to_string(kBranchColumn) +
                   " || y < 5);");
  writeBytes(directory.file("path_state.glsl"), text);
  return "shaders/path_state.glsl=" + directory.file("path_state.glsl");
}

struct Column {
  int differing = 0;
  double energy = 0;
};

/// What differs between two pictures in a column of pixels.
Column columnOf(const Image& a, const Image& b, int x) {
  Column column;
  for (int y = 0; y < a.height; ++y) {
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                                static_cast<std::size_t>(x));
    column.differing += std::memcmp(&a.rgb[at], &b.rgb[at], 3 * sizeof(float)) != 0;
    for (std::size_t i = at; i < at + 3; ++i) {
      column.energy += std::fabs(double{a.rgb[i]} - double{b.rgb[i]});
    }
  }
  return column;
}

}  // namespace

TEST_CASE("compare gives each class its share of the pixels and of their difference", "[cli][gl]") {
  const TemporaryDirectory directory;
  const ProgramResult result = runProgram(
      directory, {"compare", kLit, "--width", "16", "--height", "16", "--spp", "1", "--passes", "1",
                  "--out", "out", "--json", "-", "--override", faultyStart(directory)});
  INFO(result.err);
  REQUIRE(result.exitCode == 1);
  const Image a = readExr(directory.file("out/a.exr")).image;
  const Image b = readExr(directory.file("out/b.exr")).image;
  const Column rounding = columnOf(a, b, kRoundingColumn);
  const Column branch = columnOf(a, b, kBranchColumn);
  REQUIRE(rounding.differing > 0);
  REQUIRE(branch.differing > 0);
  REQUIRE(rounding.differing != branch.differing);

  const auto json = result.json();
  const int pixels = rounding.differing + branch.differing;
  CHECK(json["differing_pixels"] == pixels);
  const auto classes = json["classes"];
  CHECK(classes["examined_pixels"] == pixels);
  CHECK(classes.size() == 3);
  const double energy = rounding.energy + branch.energy;
  for (const auto& [name, column] :
       {std::pair{"rounding", rounding}, std::pair{"branch_flip", branch}}) {
    INFO(name);
    CHECK(classes[name]["pixels"].get<double>() == Approx(double(column.differing) / pixels));
    CHECK(classes[name]["energy"].get<double>() == Approx(column.energy / energy));
  }
  for (const char* share : {"pixels", "energy"}) {
    CHECK(classes["rounding"][share].get<double>() + classes["branch_flip"][share].get<double>() ==
          Approx(1.0).epsilon(1e-12));
  }
}

}  // namespace twintrace::test
