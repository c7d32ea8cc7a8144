#include "gpu/case_engine.h"

#include <bit>

#include "common/base/error.h"
#include "cpu/case_engine.h"
#include "tests/catch.h"
#include "tests/unit/cast/case_fixtures.h"
#include "tests/unit/cpu/caster_fixtures.h"

namespace twintrace {
namespace {

using namespace test;

constexpr std::uint64_t kSeed = 20240311;

std::unique_ptr<CaseEngine> engineOrSkip(const RenderOptions& options,
                                         const ShaderLibrary& library = ShaderLibrary()) {
  try {
    return makeGpuCaseEngine(options, library);
  } catch (const DeviceError& error) {
    WARN("skipped: " << error.what());
    return nullptr;
  }
}

bool sameBits(float a, float b) {
  const bool bothNan = a != a && b != b;
  return bothNan || a == b;  // the sign of zero is free
}

bool sameBits(const CastHit& a, const CastHit& b) {
  return a.primitive == b.primitive && sameBits(a.t, b.t) && sameBits(a.normal.x, b.normal.x) &&
         sameBits(a.normal.y, b.normal.y) && sameBits(a.normal.z, b.normal.z);
}

void expectSameAnswers(const RenderOptions& options, const CaseSet& cases) {
  const auto gpu = engineOrSkip(options);
  if (!gpu) return;
  const auto expected = makeKernelCaseEngine(options)->cast(cases);
  const auto found = gpu->cast(cases);
  REQUIRE(found.size() == expected.size());
  int hits = 0;
  int differing = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    hits += expected[i].valid();
    if (sameBits(found[i], expected[i])) continue;
    if (++differing > 3) continue;
    UNSCOPED_INFO("case " << i << " of seed " << kSeed << ", " << hexText(cases.rays[i].ray)
                          << ": cpu " << hexText(expected[i]) << " " << hexText(expected[i].normal)
                          << ", gpu " << hexText(found[i]) << " " << hexText(found[i].normal));
  }
  CHECK(differing == 0);
  CHECK(hits > 100);  // else the cases show nothing
}

TEST_CASE("gpu and cpu give the same bits for cases of all kinds", "[gpu][cases][gl]") {
  for (const auto intersector : {Intersector::robust, Intersector::report}) {
    for (const bool bounces : {false, true}) {
      for (const auto stage : {Stage::compute, Stage::fragment}) {
        RenderOptions options;
        options.intersector = intersector;
        options.stage = stage;
        INFO("report " << (intersector == Intersector::report) << ", bounces " << bounces
                       << ", fragment " << (stage == Stage::fragment));
        expectSameAnswers(options, RandomCases(kSeed).draw(4000, bounces));
      }
    }
  }
}

TEST_CASE("gpu casts no rays at all", "[gpu][cases][gl]") {
  const auto engine = engineOrSkip(RenderOptions());
  if (!engine) return;
  CHECK(engine->name() == "gpu");
  CHECK(engine->cast(CaseSet()).empty());
  CHECK(castOne(*engine, {}, {{0, 0, 4}, {0, 0, -1}}).primitive == -1);
}

TEST_CASE("gpu casts more rays than fit one dispatch", "[gpu][cases][gl]") {
  for (const auto stage : {Stage::compute, Stage::fragment}) {
    RenderOptions options;
    options.stage = stage;
    const auto engine = engineOrSkip(options);
    if (!engine) return;
    CaseSet cases = casesOf({groundPlane()}, {});
    for (int i = 0; i < (1 << 20) + 3; ++i) {
      cases.rays.push_back({{{0, 0, static_cast<float>(i)}, {0, 0, -1}}, 0});
    }
    const auto hits = engine->cast(cases);
    REQUIRE(hits.size() == cases.rays.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) wrong += hits[i].t != static_cast<float>(i);
    CHECK(wrong == 0);
  }
}

TEST_CASE("gpu casts by the shaders that are put in", "[gpu][cases][gl]") {
  const auto file = ShaderLibrary().find("ray.glsl");
  REQUIRE(file);
  std::string text = file->text;
  const std::string old = "t < best.t ||";
  REQUIRE(text.find(old) != std::string::npos);
  text.replace(text.find(old), old.size(), "false ||");
  const ShaderLibrary library({}, {{"shaders/ray.glsl", {text, ""}}});
  const auto engine = engineOrSkip(RenderOptions(), library);
  if (!engine) return;
  CHECK(castOne(*engine, {unitSphere()}, {{0, 0, 4}, {0, 0, -1}}).primitive == -1);
}

TEST_CASE("gpu refuses cases in double", "[gpu][cases]") {
  RenderOptions options;
  options.precision = Precision::float64;
  CHECK_THROWS_AS(makeGpuCaseEngine(options, ShaderLibrary()), UsageError);
}

}  // namespace
}  // namespace twintrace
