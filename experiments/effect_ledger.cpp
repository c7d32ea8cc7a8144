#include "experiments/effect_ledger.h"

#include "common/scene/effects.h"

namespace twintrace {
namespace {

/// The effects that the content calls for, without [effects].
EffectSet contentEffects(const Scene& scene, const RenderOptions& options) {
  Scene unforced = scene;
  unforced.forcedEffects.clear();
  return neededEffects(unforced, options);
}

std::string contentReason(const RenderOptions& options, Effect effect, bool needed) {
  if (effect == Effect::indirect) {
    if (needed) return "the integrator follows paths of several bounces";
    return options.integrator == Integrator::local ? "the integrator is local"
                                                   : "bounces is 1 or less";
  }
  if (effect == Effect::lens) return needed ? "the aperture is above 0" : "the aperture is 0";
  return needed ? "the scene has it" : "the scene has none";
}

std::string reasonFor(const Scene& scene, const RenderOptions& options, Effect effect,
                      const std::string& name, bool needed) {
  if (options.effects != "auto" && options.effects != "all") return "--effects lists what is in";
  const auto forced = scene.forcedEffects.find(name);
  if (forced != scene.forcedEffects.end()) {
    return forced->second ? "[effects] forces it on" : "[effects] forces it off";
  }
  if (options.effects == "all" && !needed) return "--effects all";
  return contentReason(options, effect, needed);
}

}  // namespace

std::vector<std::string> effectNames(const EffectSet& effects) {
  std::vector<std::string> names;
  for (int i = 0; i < kEffectCount; ++i) {
    if (effects.has(static_cast<Effect>(i))) {
      names.emplace_back(kEffectNames[static_cast<std::size_t>(i)]);
    }
  }
  return names;
}

std::vector<EffectEntry> effectLedger(const Scene& scene, const RenderOptions& options) {
  const EffectSet chosen = chosenEffects(scene, options);
  const EffectSet content = contentEffects(scene, options);
  std::vector<EffectEntry> ledger;
  for (int i = 0; i < kEffectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    const std::string name(kEffectNames[static_cast<std::size_t>(i)]);
    ledger.push_back(
        {name, chosen.has(effect), reasonFor(scene, options, effect, name, content.has(effect))});
  }
  return ledger;
}

}  // namespace twintrace
