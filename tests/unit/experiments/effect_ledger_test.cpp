#include "experiments/effect_ledger.h"

#include <algorithm>

#include "tests/catch.h"

namespace twintrace {
namespace {

EffectEntry entryOf(const Scene& scene, const RenderOptions& options, const std::string& name) {
  const auto ledger = effectLedger(scene, options);
  return *std::find_if(ledger.begin(), ledger.end(),
                       [&](const EffectEntry& entry) { return entry.name == name; });
}

}  // namespace

TEST_CASE("effectLedger gives the content as the reason", "[experiments]") {
  Scene scene;
  scene.lights.push_back(PointLight{});
  CHECK(entryOf(scene, {}, "pointLight").compiledIn);
  CHECK(entryOf(scene, {}, "pointLight").reason == "the scene has it");
  CHECK_FALSE(entryOf(scene, {}, "sunLight").compiledIn);
  CHECK(entryOf(scene, {}, "sunLight").reason == "the scene has none");
}

TEST_CASE("effectLedger gives integrator and bounces as reasons for indirect", "[experiments]") {
  RenderOptions options;
  CHECK(entryOf({}, options, "indirect").compiledIn);
  options.bounces = 1;
  CHECK(entryOf({}, options, "indirect").reason == "bounces is 1 or less");
  options.integrator = Integrator::local;
  CHECK(entryOf({}, options, "indirect").reason == "the integrator is local");
}

TEST_CASE("effectLedger tells who forced an effect", "[experiments]") {
  Scene scene;
  scene.forcedEffects["indirect"] = false;
  CHECK(entryOf(scene, {}, "indirect").reason == "[effects] forces it off");
  RenderOptions options;
  options.effects = "all";
  CHECK(entryOf(scene, options, "sphere").compiledIn);
  CHECK(entryOf(scene, options, "sphere").reason == "--effects all");
  CHECK_FALSE(entryOf(scene, options, "indirect").compiledIn);
  options.effects = "sphere";
  CHECK(entryOf(scene, options, "box").reason == "--effects lists what is in");
}

}  // namespace twintrace
