#include "common/stats/multiple_testing.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace twintrace {

std::vector<double> holmAdjusted(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double running = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const double factor = static_cast<double>(p.size() - rank);
    running = std::max(running, std::min(1.0, factor * p[order[rank]]));
    adjusted[order[rank]] = running;
  }
  return adjusted;
}

double benjaminiHochbergCut(std::vector<double> p, double q) {
  std::sort(p.begin(), p.end());
  for (std::size_t rank = p.size(); rank > 0; --rank) {
    if (p[rank - 1] <= q * static_cast<double>(rank) / static_cast<double>(p.size()))
      return p[rank - 1];
  }
  return -1.0;
}

}  // namespace twintrace
