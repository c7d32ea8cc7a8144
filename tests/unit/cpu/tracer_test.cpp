#include "cpu/tracer.h"

#include <algorithm>
#include <cmath>

#include "common/base/error.h"
#include "common/base/float_bits.h"
#include "common/film/film.h"
#include "common/film/film_file.h"
#include "tests/catch.h"
#include "tests/unit/cpu/render_fixtures.h"
#include "tests/unit/film/film_fixtures.h"

namespace twintrace {
namespace {

constexpr int kSize = 45;  // pixels: whole tiles and partial ones
constexpr int kFrames = 4;

/// All kinds of primitive between them, lights, an image, a lens.
const std::vector<std::string> kScenes = {"cornell", "open", "local-lights"};

RenderOptions optionsOf(const Scene& scene, Integrator integrator = Integrator::path) {
  RenderOptions options = test::squareOptions(scene, kSize, integrator);
  options.passes = 2;
  return options;
}

void addFrames(Film& film, const Scene& scene, const RenderOptions& options,
               const CpuTracerSettings& settings, int first, int last) {
  for (int frame = first; frame < last; ++frame) {
    const auto sample = static_cast<std::uint32_t>(frame * options.passes);
    film.addFrame(test::frameSums(scene, options, settings, sample), options.passes, sample);
  }
}

std::string bytesOf(const Film& film) {
  const test::TemporaryDirectory directory;
  writeFilm(directory.file("a.film"), film);
  return test::bytesOf(directory.file("a.film"));
}

std::string filmBytes(const Scene& scene, const RenderOptions& options,
                      const CpuTracerSettings& settings = {}) {
  Film film(kSize, kSize, {});
  addFrames(film, scene, options, settings, 0, kFrames);
  return bytesOf(film);
}

bool sameSums(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), sameBits);
}

}  // namespace

TEST_CASE("the CPU tracer's film does not depend on the number of threads", "[cpu]") {
  for (const std::string& name : kScenes) {
    INFO(name);
    const Scene scene = test::shippedScene(name);
    RenderOptions options = optionsOf(scene);
    options.threads = 1;
    const std::string one = filmBytes(scene, options);
    for (const int threads : {2, 5}) {
      INFO(threads << " threads");
      options.threads = threads;
      CHECK(filmBytes(scene, options) == one);
    }
  }
}

TEST_CASE("the CPU tracer's film does not depend on the size of tiles", "[cpu]") {
  for (const std::string& name : kScenes) {
    INFO(name);
    const Scene scene = test::shippedScene(name);
    const RenderOptions options = optionsOf(scene);
    const std::string usual = filmBytes(scene, options);
    for (const int tileSize : {1, 8, 57}) {
      INFO("tiles of " << tileSize);
      CHECK(filmBytes(scene, options, {bestInstructionSet(), tileSize}) == usual);
    }
  }
}

TEST_CASE("frames rendered in two runs and merged are one run's film", "[cpu]") {
  for (const std::string& name : kScenes) {
    INFO(name);
    const Scene scene = test::shippedScene(name);
    const RenderOptions options = optionsOf(scene);
    Film early(kSize, kSize, {});
    Film late(kSize, kSize, {});
    addFrames(early, scene, options, {}, 0, 1);
    addFrames(late, scene, options, {}, 1, kFrames);
    late.merge(early);
    CHECK(bytesOf(late) == filmBytes(scene, options));
  }
}

TEST_CASE("another seed or another sample range gives another film", "[cpu]") {
  const Scene scene = test::shippedScene("cornell");
  const RenderOptions options = optionsOf(scene);
  RenderOptions reseeded = options;
  reseeded.seed = options.seed + 1;
  const auto sums = test::frameSums(scene, options);
  CHECK_FALSE(sameSums(sums, test::frameSums(scene, reseeded)));
  CHECK_FALSE(sameSums(sums, test::frameSums(scene, options, {}, 2)));
}

TEST_CASE("wide lanes of every instruction set render the scalar picture", "[cpu]") {
  for (const std::string& name : kScenes) {
    const Scene scene = test::shippedScene(name);
    for (const auto integrator :
         {Integrator::path, Integrator::report, Integrator::whitted, Integrator::local}) {
      RenderOptions options = optionsOf(scene, integrator);
      options.lanes = Lanes::scalar;
      const auto scalar = test::frameSums(scene, options);
      options.lanes = Lanes::wide;
      for (const auto set : {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
        if (set > bestInstructionSet()) continue;
        INFO(name << ", integrator " << static_cast<int>(integrator) << ", "
                  << instructionSetName(set));
        CHECK(sameSums(scalar, test::frameSums(scene, options, {set, 32})));
      }
    }
  }
}

// Native maths and double precision draw the same random numbers, so that a path differs from the
// strict one by rounding, until a decision near its threshold goes the other way. A path makes some
// dozen such decisions, with rounding errors of at most about 1e-5 each after six bounces: fewer
// than one in a thousand diverges, some four of 2025 pixels with two samples. 1 % is above that by
// a factor of five, and far below what a wrong function would do.
/// Checks that two arms' pictures are close; gives how many values differ at all.
std::size_t checkClose(const Scene& scene, const RenderOptions& strict,
                       const RenderOptions& other) {
  constexpr double kRounding = 1e-3;
  const auto a = test::frameSums(scene, strict);
  const auto b = test::frameSums(scene, other);
  std::size_t diverged = 0;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool close = std::fabs(double{a[i]} - b[i]) <= kRounding * std::max(a[i], b[i]);
    diverged += close ? 0 : 1;
    differing += sameBits(a[i], b[i]) ? 0 : 1;
  }
  INFO(scene.name << ": " << differing << " values differ, " << diverged << " by more than "
                  << kRounding);
  CHECK(diverged * 100 <= a.size());
  return differing;
}

TEST_CASE("native maths and double precision stay close to strict maths", "[cpu]") {
  std::size_t nativeDiffers = 0;
  std::size_t doubleDiffers = 0;
  for (const std::string& name : kScenes) {
    const Scene scene = test::shippedScene(name);
    const RenderOptions strict = optionsOf(scene);
    RenderOptions native = strict;
    native.maths = Maths::native;
    nativeDiffers += checkClose(scene, strict, native);
    RenderOptions precise = strict;
    precise.precision = Precision::float64;
    doubleDiffers += checkClose(scene, strict, precise);
  }
  CHECK(nativeDiffers > 0);
  CHECK(doubleDiffers > 0);
}

TEST_CASE("chosenLanes falls back to scalar lanes unless wide ones were asked for", "[cpu]") {
  RenderOptions options;
  CHECK(chosenLanes(options) == Lanes::wide);
  options.maths = Maths::native;
  CHECK(chosenLanes(options) == Lanes::scalar);
  options.lanesGiven = true;
  CHECK_THROWS_AS(chosenLanes(options), UsageError);
  options.maths = Maths::strict;
  CHECK(chosenLanes(options) == Lanes::wide);
  options.precision = Precision::float64;
  CHECK_THROWS_AS(chosenLanes(options), UsageError);
  options.lanes = Lanes::scalar;
  CHECK(chosenLanes(options) == Lanes::scalar);
}

TEST_CASE("makeCpuRenderer refuses options that exclude each other", "[cpu]") {
  const Scene scene = test::shippedScene("cornell");
  RenderOptions options = optionsOf(scene);
  options.precision = Precision::float64;
  options.hull = "embree";
  CHECK_THROWS_AS(test::cpuRendererOf(scene, options), UsageError);
  options.hull = "none";
  options.lanesGiven = true;
  CHECK_THROWS_AS(test::cpuRendererOf(scene, options), UsageError);
}

TEST_CASE("the CPU tracer says which lanes and instruction set it runs", "[cpu]") {
  const Scene scene = test::shippedScene("furnace-mirror");
  const auto renderer = test::cpuRendererOf(scene, optionsOf(scene), {InstructionSet::sse2, 32});
  const Provenance facts = renderer->provenance();
  const auto holds = [&](const std::string& key, const std::string& value) {
    return std::find(facts.begin(), facts.end(), std::pair(key, value)) != facts.end();
  };
  CHECK(holds("lanes", "wide"));
  CHECK(holds("instruction_set", "sse2"));
}

}  // namespace twintrace
