#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/hulls/hull_caster.h"
#include "common/scene/scene.h"
#include "cpu/ray_sets.h"
#include "experiments/job_control.h"

namespace twintrace {

/// Where rays are cast: `cpu` in float, `cpu64` in double, `gpu`; and by the witness with its own tree and
/// primitives, `embree` in its robust mode and `embree-fast` in its default one.
extern const std::vector<std::string> kHullEngines;

/// What is measured in each scene.
struct HullPlan {
  std::vector<std::string> strategies;
  std::vector<RayKind> kinds;
  std::vector<std::string> engines;
  int repeats = 5;
  int mostRays = 1 << 16;  ///< of a kind; of more, evenly spaced ones are taken
};

/// The structure of one strategy in one scene.
struct HullFacts {
  std::string strategy;
  int primitives = 0;  ///< with bounds
  int nodes = 0;
  int depth = 0;
  double buildSeconds = 0.0;
  double bytesPerPrimitive = 0.0;
  double sahCost = 0.0;
  double areaRatio = 0.0;    ///< surface area of the outermost hulls over that of their contents' own
  double volumeRatio = 0.0;  ///< convex hulls; 0 where nothing is contained
};

/// One strategy, ray kind and engine in one scene.
struct HullRun {
  std::string scene;
  HullFacts facts;
  RayKind kind = RayKind::primary;
  std::string engine;
  int threads = 0;  ///< 0 = all
  std::size_t rays = 0;
  std::size_t hits = 0;
  std::size_t differing = 0;  ///< rays whose answer is not that of the scene's first strategy
  HullTotals totals;  ///< over all rays
  std::vector<double> seconds;  ///< by repeat, of all rays
  std::string missing;          ///< why it could not run, or empty

  double bestSeconds() const;
  double medianSeconds() const;
};

/// Measures all strategies in a scene. The repeats go round all strategies, back and forth, so that drift
/// of the machine's speed cancels; counters come from a run of their own.
/// @param options film, seed, threads, stage and provider
/// @throws UsageError for a strategy, engine or scene that can't be measured.
std::vector<HullRun> measureHulls(const Scene& scene, const RenderOptions& options,
                                  const HullPlan& plan, const JobControl& control);

/// What each pixel's primary ray costs with a strategy, row by row.
std::vector<HullCounts> primaryCounts(const Scene& scene, const RenderOptions& options,
                                      const std::string& strategy);

}  // namespace twintrace
