#include "common/stats/chi_square.h"

#include <cmath>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/stats/distributions.h"

namespace twintrace {
namespace {

constexpr double kSmallestExpectation = 5.0;

struct Pool {
  double observed = 0.0;
  double expected = 0.0;
};

void requireComparable(std::span<const std::uint64_t> observed, std::span<const double> expected) {
  if (observed.size() != expected.size()) {
    throw UsageError("found " + std::to_string(observed.size()) + " counts, expected " +
                     std::to_string(expected.size()));
  }
  Pool total;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!(expected[i] >= 0.0) || std::isinf(expected[i])) {
      throw UsageError("found an expected count of " + std::to_string(expected[i]));
    }
    total.observed += static_cast<double>(observed[i]);
    total.expected += expected[i];
  }
  if (std::abs(total.observed - total.expected) > 1e-6 * total.observed) {
    throw UsageError("found expected counts that add up to " + std::to_string(total.expected) +
                     ", expected " + std::to_string(total.observed));
  }
}

std::vector<Pool> poolBins(std::span<const std::uint64_t> observed,
                           std::span<const double> expected) {
  std::vector<Pool> pools;
  Pool open;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    open.observed += static_cast<double>(observed[i]);
    open.expected += expected[i];
    if (open.expected < kSmallestExpectation) continue;
    pools.push_back(open);
    open = Pool{};
  }
  if (pools.empty()) return {open};
  pools.back().observed += open.observed;
  pools.back().expected += open.expected;
  return pools;
}

}  // namespace

ChiSquare chiSquareTest(std::span<const std::uint64_t> observed, std::span<const double> expected) {
  requireComparable(observed, expected);
  const std::vector<Pool> pools = poolBins(observed, expected);
  ChiSquare result;
  result.dof = static_cast<int>(pools.size()) - 1;
  for (const Pool& pool : pools) {
    if (pool.expected == 0.0) continue;
    const double difference = pool.observed - pool.expected;
    result.statistic += difference * difference / pool.expected;
  }
  if (result.dof > 0) result.p = chiSquareUpper(result.statistic, result.dof);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] == 0.0 && observed[i] != 0) result.p = 0.0;
  }
  return result;
}

}  // namespace twintrace
