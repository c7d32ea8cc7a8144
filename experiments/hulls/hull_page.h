#pragma once

#include <span>
#include <string>

#include "experiments/hulls/cost_model.h"

namespace twintrace {

/// A page that stands alone, with plots as SVG: rays per second against the number of primitives for each
/// strategy, hull tests against primitive tests, the cost model, and all numbers.
std::string hullPage(std::span<const HullRun> runs, std::span<const HullCost> costs);

}  // namespace twintrace
