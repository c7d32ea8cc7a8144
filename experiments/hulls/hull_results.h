#pragma once

#include <span>
#include <string>

#include "experiments/hulls/cost_model.h"
#include "experiments/results_json.h"

namespace twintrace {

/// `scene/strategy/raykind/backend`.
std::string runName(const HullRun& run);

/// The run without hulls of the same scene, rays and engine, or null.
const HullRun* sweepOf(const HullRun& run, std::span<const HullRun> all);

/// Rays from which on building the hulls has paid, against testing every primitive; infinite if they are
/// no faster.
double breakEvenRays(const HullRun& run, const HullRun& sweep);

/// For people: one table for each scene, kind of rays and engine.
std::string hullTable(std::span<const HullRun> runs);

/// The cost model in a few lines.
std::string costTable(std::span<const HullCost> costs);

/// In Google Benchmark's shape: every repeat, with the counters (design of its compare.py).
Json hullJson(std::span<const HullRun> runs, std::span<const HullCost> costs);

/// One line for each run, with a header.
std::string hullCsv(std::span<const HullRun> runs);

}  // namespace twintrace
