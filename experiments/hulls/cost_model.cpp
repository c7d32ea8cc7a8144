#include "experiments/hulls/cost_model.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "common/hulls/hull_structure.h"

namespace twintrace {
namespace {

using Row = std::array<double, 3>;  ///< 1, hull tests and primitive tests of a ray

Row rowOf(const HullRun& run) {
  const auto rays = static_cast<double>(std::max<std::size_t>(run.rays, 1));
  return {1.0, static_cast<double>(run.totals.hullTests) / rays,
          static_cast<double>(run.totals.primitiveTests) / rays};
}

std::string volumeOf(const HullRun& run) {
  const HullStrategy* strategy = findHullStrategy(run.facts.strategy);
  if (strategy == nullptr || strategy->arrangement == HullArrangement::none) return "";
  std::string name(strategy->volume.name);
  if (strategy->volume.slabs != 0) name += " of " + std::to_string(std::popcount(strategy->volume.slabs)) + " slabs";
  if (strategy->arrangement == HullArrangement::wide) name += ", eight at a time";
  return name;
}

/// Solves the normal equations by elimination with pivots; nothing if they are singular.
std::optional<Row> solve(std::array<std::array<double, 4>, 3> m) {
  for (std::size_t column = 0; column < 3; ++column) {
    std::size_t pivot = column;
    for (std::size_t i = column + 1; i < 3; ++i) {
      if (std::fabs(m[i][column]) > std::fabs(m[pivot][column])) pivot = i;
    }
    std::swap(m[column], m[pivot]);
    if (std::fabs(m[column][column]) < 1e-12) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == column) continue;
      const double factor = m[i][column] / m[column][column];
      for (std::size_t k = column; k < 4; ++k) m[i][k] -= factor * m[column][k];
    }
  }
  return Row{m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]};
}

std::optional<Row> fit(const std::vector<const HullRun*>& runs) {
  std::array<std::array<double, 4>, 3> m{};
  for (const HullRun* run : runs) {
    const double time = measuredNanoseconds(*run);
    Row row = rowOf(*run);
    for (double& x : row) x /= time;  // so that relative errors are what is squared
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) m[i][k] += row[i] * row[k];
      m[i][3] += row[i];
    }
  }
  return solve(m);
}

}  // namespace

double measuredNanoseconds(const HullRun& run) {
  return 1e9 * run.bestSeconds() / static_cast<double>(std::max<std::size_t>(run.rays, 1));
}

double predictedNanoseconds(const HullCost& cost, const HullRun& run) {
  const Row row = rowOf(run);
  return cost.fixed + cost.hullTest * row[1] + cost.primitiveTest * row[2];
}

std::vector<HullCost> fitCosts(std::span<const HullRun> runs) {
  std::vector<HullCost> costs;
  for (const HullRun& first : runs) {
    const std::string volume = volumeOf(first);
    const auto isFitted = [&](const HullCost& cost) {
      return cost.engine == first.engine && cost.volume == volume;
    };
    if (volume.empty() || std::ranges::any_of(costs, isFitted)) continue;
    std::vector<const HullRun*> used;
    for (const HullRun& run : runs) {
      const bool counted = run.totals.primitiveTests > 0 && !run.seconds.empty();
      const std::string other = volumeOf(run);
      if (run.engine == first.engine && counted && (other == volume || other.empty())) used.push_back(&run);
    }
    const std::optional<Row> found = used.size() > 3 ? fit(used) : std::nullopt;
    if (!found) continue;
    HullCost cost{first.engine, volume, (*found)[0], (*found)[1], (*found)[2], 0.0, static_cast<int>(used.size())};
    for (const HullRun* run : used) {
      const double time = measuredNanoseconds(*run);
      cost.error += std::fabs(predictedNanoseconds(cost, *run) - time) / time / cost.runs;
    }
    costs.push_back(cost);
  }
  return costs;
}

}  // namespace twintrace
