#include "common/cast/scene_cases.h"

#include "cpu/case_engine.h"
#include "cpu/kernel_caster.h"
#include "tests/catch.h"
#include "tests/unit/cast/case_fixtures.h"
#include "tests/unit/cpu/caster_fixtures.h"

namespace twintrace {
namespace {

/// One shape of each kind, in another order than a flat scene's.
std::shared_ptr<const FlatScene> mixedScene() {
  return test::flatSceneOf({PlaneShape{{0.0f, -2.0f, 0.0f}, {0.0f, 1.0f, 0.0f}},
                            BoxShape{{3.0f, 0.0f, 0.0f}, glm::vec3(2.0f), glm::vec3(10, 20, 30)},
                            SphereShape{{0.0f, 0.5f, 0.0f}, 1.0f},
                            BoxShape{{-3.0f, 0.0f, 0.0f}, glm::vec3(2.0f), glm::vec3(0.0f)}});
}

TEST_CASE("a scene as cases has its primitives in the flat scene's order", "[cast][cases]") {
  FlatScene scene = *mixedScene();
  scene.objectNames = {"floor", "turned", "ball", "crate"};
  const CaseSet cases = casesOf(scene, {});
  REQUIRE(cases.primitives.size() == 4);
  CHECK(cases.primitives[0].kind == CaseKind::sphere);
  CHECK(cases.primitives[1].kind == CaseKind::box);
  CHECK(cases.primitives[2].kind == CaseKind::orientedBox);
  CHECK(cases.primitives[3].kind == CaseKind::plane);
  CHECK(cases.primitiveNames == std::vector<std::string>{"ball", "crate", "turned", "floor"});
  CHECK(cases.primitives[3].vector(0) == glm::vec3(0, 1, 0));
  CHECK(cases.primitives[3].vector(3) == glm::vec3(0, -2, 0));
  REQUIRE(cases.scenes.size() == 1);
  CHECK(cases.scenes[0].count == 4);
}

TEST_CASE("a scene as cases has the hits of the scene", "[cast][cases]") {
  const auto scene = mixedScene();
  std::vector<CastRay> rays;
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 target(0.6f * static_cast<float>(i % 20) - 6.0f,
                           0.25f * static_cast<float>(i / 20) - 2.6f, 0.0f);
    rays.push_back({{0.1f, 0.7f, 9.0f}, target - glm::vec3(0.1f, 0.7f, 9.0f)});
  }
  const auto expected = makeKernelCaster(scene, RenderOptions())->cast(rays);
  const auto found = makeKernelCaseEngine(RenderOptions())->cast(casesOf(*scene, rays));
  REQUIRE(found.size() == rays.size());
  int hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    INFO(test::hexText(rays[i]));
    CHECK(found[i].primitive == expected[i].primitive);
    hits += found[i].valid();
    if (found[i].valid()) CHECK(found[i].t == expected[i].t);
  }
  CHECK(hits > 200);
}

}  // namespace
}  // namespace twintrace
