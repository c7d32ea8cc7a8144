#pragma once

#include <string>
#include <vector>

#include "common/scene/effects.h"
#include "common/scene/scene.h"

namespace twintrace {

/// Whether one effect is compiled in, and why in brief.
struct EffectEntry {
  std::string name;
  bool compiledIn = false;
  std::string reason;
};

/// Names of the effects of a set, in the order of kEffectNames.
std::vector<std::string> effectNames(const EffectSet& effects);

/// All effects of a scene under options, in the order of kEffectNames.
std::vector<EffectEntry> effectLedger(const Scene& scene, const RenderOptions& options);

}  // namespace twintrace
