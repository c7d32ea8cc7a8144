#include <algorithm>

#include "common/hulls/hull_structure.h"
#include "hull_strategy_list.h"  // generated: every file of common/hulls/strategies

namespace twintrace {
namespace {

/// Primitives up to which a scene is searched without hulls: below, the GPU has them as literals.
constexpr int kFew = 64;

}  // namespace

const std::vector<HullStrategy>& hullStrategies() {
  static const std::vector<HullStrategy> strategies = [] {
    std::vector<HullStrategy> all = {
        {"none", "every primitive is tested", HullArrangement::none, HullGrouping::objects, {}}};
    for (const auto add : kHullStrategyFiles) add(all);
    return all;
  }();
  return strategies;
}

const HullStrategy* findHullStrategy(std::string_view name) {
  const auto& all = hullStrategies();
  const auto found = std::ranges::find(all, name, &HullStrategy::name);
  return found == all.end() ? nullptr : &*found;
}

std::shared_ptr<const HullStructure> chosenHulls(const FlatScene& scene,
                                                 const RenderOptions& options) {
  const bool automatic = options.hull == "auto";
  if (automatic && scene.index.boundedCount() <= kFew) return nullptr;
  const HullStrategy* strategy = findHullStrategy(automatic ? "bvh" : options.hull);
  if (strategy == nullptr || strategy->arrangement == HullArrangement::none) return nullptr;
  auto hulls = std::make_shared<const HullStructure>(buildHulls(scene, *strategy));
  return hulls->nodeCount > 0 ? hulls : nullptr;
}

std::string hullName(const FlatScene& scene) {
  return scene.hulls == nullptr ? "none" : scene.hulls->strategy;
}

}  // namespace twintrace
