#include "common/hulls/hull_structure.h"

#include "common/base/error.h"
#include "common/hulls/tightness.h"
#include "cpu/hull_caster.h"
#include "gpu/hull_caster.h"
#include "tests/catch.h"
#include "tests/unit/hulls/hull_fixtures.h"

using namespace twintrace;
using namespace twintrace::test;

namespace {

struct Place {
  glm::vec3 center;
  float size;
};
constexpr Place kPlaces[] = {{{0.0f, 0.0f, 0.0f}, 1.0f},
                             {{1e6f, -1e6f, 1e6f}, 3.0f},
                             {{-100.0f, 3.0f, 0.5f}, 1e-3f},
                             {{0.0f, 1e5f, 0.0f}, 1e4f}};

std::vector<HullHit> answers(HullCaster& caster, const std::vector<CastRay>& rays) {
  std::vector<HullHit> hits(rays.size());
  caster.cast(rays, hits);
  return hits;
}

std::size_t differing(const std::vector<HullHit>& a, const std::vector<HullHit>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] == b[i] ? 0 : 1;
  return count;
}

std::size_t hitCount(const std::vector<HullHit>& hits) {
  std::size_t count = 0;
  for (const HullHit& hit : hits) count += hit.primitive == layout::kNoPrimitive ? 0 : 1;
  return count;
}

/// Strategies whose hulls both back ends have.
std::vector<std::string> sharedStrategies() {
  std::vector<std::string> names;
  for (const HullStrategy& strategy : hullStrategies()) {
    if (strategy.arrangement != HullArrangement::wide) names.push_back(strategy.name);
  }
  return names;
}

std::vector<std::string> allStrategies() {
  std::vector<std::string> names;
  for (const HullStrategy& strategy : hullStrategies()) names.push_back(strategy.name);
  return names;
}

}  // namespace

TEST_CASE("every strategy finds what testing every primitive finds", "[hulls]") {
  for (const Place& place : kPlaces) {
    const Scene scene = mixedScene(7, place.center, place.size);
    const auto rays = mixedRays(8, place.center, place.size, 20000);
    const auto expected =
        answers(*makeCpuHullCaster(flatWith(scene, "none"), RenderOptions{}), rays);
    CHECK(hitCount(expected) > rays.size() / 3);
    CHECK(hitCount(expected) < rays.size());
    for (const std::string& name : allStrategies()) {
      CAPTURE(name, place.size);
      const auto caster = makeCpuHullCaster(flatWith(scene, name), RenderOptions{});
      CHECK(differing(answers(*caster, rays), expected) == 0);
    }
  }
}

TEST_CASE("no strategy loses hits that are hard to have", "[hulls]") {
  for (const Place& place : {Place{{0.0f, 0.0f, 0.0f}, 1.0f}, Place{{3e4f, -1e4f, 2e4f}, 0.5f}}) {
    HullRandom random(5);
    const float size = place.size;
    const Mesh mesh = triangleCloud(random, place.center, size, 0.05f * size, 3000);
    Scene scene;
    scene.materials.emplace_back().albedo = glm::vec3(0.5f);
    addMesh(scene, mesh);
    addMesh(scene, mesh);  // once more: of equal hits the first counts
    const glm::vec3 ball = place.center + glm::vec3(0.3f * size);
    for (int i = 0; i < 2; ++i) addObject(scene, SphereShape{ball, 0.2f * size});
    const auto rays = grazingRays(6, mesh, ball, 0.2f * size, 4000);
    const auto expected =
        answers(*makeCpuHullCaster(flatWith(scene, "none"), RenderOptions{}), rays);
    CHECK(hitCount(expected) > rays.size() / 4);
    for (const std::string& name : allStrategies()) {
      CAPTURE(name, size);
      const auto caster = makeCpuHullCaster(flatWith(scene, name), RenderOptions{});
      CHECK(differing(answers(*caster, rays), expected) == 0);
    }
  }
}

TEST_CASE("every strategy ends on rays that are not numbers, and in scenes of few kinds", "[hulls]") {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  std::vector<CastRay> rays;
  for (const float odd : {kNan, kInf, -kInf, 0.0f}) {
    rays.push_back({{odd, odd, odd}, {0.0f, 0.0f, 1.0f}});
    rays.push_back({{0.0f, 0.0f, 0.0f}, {odd, odd, odd}});
    rays.push_back({{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, odd, odd});
    rays.push_back({{0.0f, odd, 0.0f}, {1.0f, 0.0f, odd}});
  }
  RenderOptions few;
  few.effects = "sphere,diffuse";
  for (const std::string& name : allStrategies()) {
    CAPTURE(name);
    const Scene scene = mixedScene(7, {}, 1.0f);
    CHECK(answers(*makeCpuHullCaster(flatWith(scene, name), RenderOptions{}), rays).size() == rays.size());
    CHECK(answers(*makeCpuHullCaster(flatWith(Scene{}, name), RenderOptions{}), rays).size() == rays.size());
    const auto some = mixedRays(8, {}, 1.0f, 2000);
    CHECK(differing(answers(*makeCpuHullCaster(flatWith(scene, name, few), few), some),
                    answers(*makeCpuHullCaster(flatWith(scene, "none", few), few), some)) == 0);
  }
}

TEST_CASE("strategies agree in double and in native maths", "[hulls]") {
  const Scene scene = mixedScene(17, {}, 1.0f);
  const auto rays = mixedRays(18, {}, 1.0f, 5000);
  RenderOptions doubles;
  doubles.precision = Precision::float64;
  RenderOptions native;
  native.maths = Maths::native;
  for (const RenderOptions& options : {doubles, native}) {
    const auto expected = answers(*makeCpuHullCaster(flatWith(scene, "none"), options), rays);
    for (const std::string& name : sharedStrategies()) {
      CAPTURE(name);
      const auto caster = makeCpuHullCaster(flatWith(scene, name), options);
      CHECK(differing(answers(*caster, rays), expected) == 0);
    }
    CHECK_THROWS_AS(makeCpuHullCaster(flatWith(scene, "bvh8"), options), UsageError);
  }
}

TEST_CASE("counters add up", "[hulls]") {
  const Scene scene = mixedScene(27, {}, 1.0f);
  const auto rays = mixedRays(28, {}, 1.0f, 2000);
  for (const std::string& name : allStrategies()) {
    CAPTURE(name);
    const auto flat = flatWith(scene, name);
    HullCounts sum;
    const auto counts = makeCpuHullCaster(flat, RenderOptions{})->count(rays);
    for (const HullCounts& each : counts) sum = sum + each;
    if (flat->hulls == nullptr) {
      CHECK(sum.primitiveTests == flat->index.boundedCount() * static_cast<int>(rays.size()));
      CHECK(sum.hullTests == 0);
      continue;
    }
    CHECK(sum.hullHits <= sum.hullTests);
    CHECK(sum.falseHullHits <= sum.hullHits);
    CHECK(sum.primitiveTests > 0);
    CHECK(sum.primitiveTests < flat->index.boundedCount() * static_cast<int>(rays.size()));
    const bool heap = flat->hulls->arrangement == HullArrangement::heap;
    CHECK((sum.heapPushes > 0) == heap);
    if (flat->hulls->arrangement == HullArrangement::flat) {
      CHECK(sum.hullTests == flat->hulls->nodeCount * static_cast<int>(rays.size()));
    }
  }
}

TEST_CASE("a full heap walks what finds no room", "[hulls]") {
  // Balls about one point; the first ray meets all of their hulls but no ball, so that nothing ends the
  // search and the smaller hulls of the leaves wait for all others.
  Scene scene;
  scene.materials.emplace_back();
  HullRandom random(3);
  for (int i = 0; i < 1000; ++i) {
    addObject(scene, SphereShape{{0.0f, 0.0f, 0.0f}, random.uniform(0.97f, 1.0f)});
  }
  const glm::vec3 d = glm::normalize(glm::vec3(1.0f, -1.0f, 0.3f));
  const glm::vec3 corner(0.85f, 0.85f, 0.0f);
  const std::vector<CastRay> rays = {{corner * 0.86f - d * 4.0f, d}, {glm::vec3(0.1f) - d * 4.0f, d}};
  const auto flat = flatWith(scene, "kay-kajiya-tree");
  const auto caster = makeCpuHullCaster(flat, RenderOptions{});
  HullCounts sum;
  for (const HullCounts& each : caster->count(rays)) sum = sum + each;
  CHECK(sum.heapOverflows > 0);
  CHECK(answers(*caster, rays) ==
        answers(*makeCpuHullCaster(flatWith(scene, "none"), RenderOptions{}), rays));
}

TEST_CASE("both back ends find and count the same", "[gl][hulls]") {
  const Scene scene = mixedScene(37, {}, 1.0f);
  const auto rays = mixedRays(38, {}, 1.0f, 3000);
  const auto expected = answers(*makeCpuHullCaster(flatWith(scene, "none"), RenderOptions{}), rays);
  for (const std::string& name : sharedStrategies()) {
    for (const Stage stage : {Stage::fragment, Stage::compute}) {
      if (stage == Stage::compute && name.starts_with("kdop")) continue;  // once is enough
      CAPTURE(name, static_cast<int>(stage));
      RenderOptions options;
      options.stage = stage;
      options.geometry = Geometry::buffer;
      const auto flat = flatWith(scene, name, options);
      std::unique_ptr<HullCaster> gpu;
      try {
        gpu = makeGpuHullCaster(flat, options);
      } catch (const DeviceError& error) {
        WARN("skipped: " << error.what());
        return;
      }
      const auto onGpu = answers(*gpu, rays);
      CHECK(differing(onGpu, expected) == 0);
      CHECK(gpu->count(rays) == makeCpuHullCaster(flat, options)->count(rays));
    }
  }
}

TEST_CASE("the gpu refuses bvh8", "[hulls]") {
  const auto flat = flatWith(mixedScene(1, {}, 1.0f), "bvh8");
  RenderOptions options;
  options.hull = "bvh8";
  CHECK_THROWS_WITH(makeGpuHullCaster(flat, options), Catch::Contains("hull bvh8 with backend gpu"));
}

TEST_CASE("small scenes have no hulls unless asked", "[hulls]") {
  Scene scene;
  scene.materials.emplace_back();
  for (int i = 0; i < 64; ++i) addObject(scene, SphereShape{{float(i), 0.0f, 0.0f}, 0.4f});
  CHECK(hullName(*flatWith(scene, "auto")) == "none");
  CHECK(hullName(*flatWith(scene, "aabb")) == "aabb");
  addObject(scene, SphereShape{});
  CHECK(hullName(*flatWith(scene, "auto")) == "bvh");
  CHECK(hullName(*flatWith(scene, "none")) == "none");
  CHECK(hullName(*flatWith(Scene{}, "bvh")) == "none");
}

TEST_CASE("tightness is 1 where the hull is the object's own shape", "[hulls]") {
  Scene ball;
  ball.materials.emplace_back();
  addObject(ball, SphereShape{{1.0f, 2.0f, 3.0f}, 0.5f});
  const auto of = [](const Scene& scene, const std::string& name) {
    const auto flat = flatWith(scene, name);
    return tightnessOf(*flat, *flat->hulls);
  };
  CHECK(of(ball, "sphere").area == Approx(1.0).epsilon(1e-5));
  CHECK(of(ball, "sphere").volume == Approx(1.0).epsilon(1e-5));
  CHECK(of(ball, "aabb").area == Approx(6.0 / M_PI).epsilon(1e-5));
  CHECK(of(ball, "bvh").volume == Approx(6.0 / M_PI).epsilon(1e-5));
  Scene box;
  box.materials.emplace_back();
  BoxShape shape;
  shape.center = {1.0f, 0.0f, 0.0f};
  shape.size = {1.0f, 2.0f, 3.0f};
  shape.rotation = {20.0f, 30.0f, 40.0f};
  addObject(box, shape);
  CHECK(of(box, "obb").area == Approx(1.0).epsilon(0.02));
  CHECK(of(box, "aabb").area > 1.2);
  CHECK(of(box, "kdop14").volume < of(box, "aabb").volume);
}
