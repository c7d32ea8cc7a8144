#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/hulls/laboratory.h"

namespace twintrace {

/// Nanoseconds that a ray takes: fixed + hullTest * its hull tests + primitiveTest * its primitive tests.
struct HullCost {
  std::string engine;
  std::string volume;  ///< of the hulls, as hull tests of one volume cost the same
  double fixed = 0.0;
  double hullTest = 0.0;
  double primitiveTest = 0.0;
  double error = 0.0;  ///< mean of |predicted - measured| / measured over the runs fitted
  int runs = 0;
};

/// Fits the model to the best times of each engine's runs, volume by volume and together with the runs
/// without hulls, by least squares of the relative errors. Engines that count nothing, and volumes with too
/// few runs to tell, are left out.
std::vector<HullCost> fitCosts(std::span<const HullRun> runs);

/// What the model says a run takes per ray, in nanoseconds.
double predictedNanoseconds(const HullCost& cost, const HullRun& run);

/// What a run took per ray, in nanoseconds.
double measuredNanoseconds(const HullRun& run);

}  // namespace twintrace
