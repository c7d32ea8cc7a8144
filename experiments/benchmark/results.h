#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/benchmark/ratios.h"

namespace twintrace {

/// Table of the arms' rates: best repeat by wall and by CPU time, and how far repeats lie apart.
std::string ratesTable(const SceneTimes& times);

/// Table of ratios with bound and PASS or MISSED.
std::string ratiosTable(const std::vector<Ratio>& ratios);

/// All repeats in Google Benchmark's shape, so that its compare.py reads them; `ratios` is extra.
nlohmann::json resultsJson(const std::vector<SceneTimes>& scenes, const std::vector<Ratio>& ratios);

}  // namespace twintrace
