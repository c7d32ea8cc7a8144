#include "experiments/probe/ulp_histogram.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace twintrace::probe {

void UlpHistogram::add(std::uint32_t ulps) {
  const bool none = ulps == 0xffffffffu;
  ++counts_[none ? kBinCount - 1 : static_cast<std::size_t>(std::bit_width(ulps))];
  largest_ = std::max(largest_, ulps);
}

std::size_t UlpHistogram::total() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
}

std::string UlpHistogram::within(double share) const {
  const double wanted = share * static_cast<double>(total());
  std::size_t bin = 0;
  double reached = static_cast<double>(counts_[0]);
  while (reached < wanted) reached += static_cast<double>(counts_[++bin]);
  return label(bin);
}

std::string UlpHistogram::label(std::size_t bin) {
  if (bin == kBinCount - 1) return "other";
  if (bin < 2) return std::to_string(bin);
  const std::uint64_t low = std::uint64_t{1} << (bin - 1);
  return std::to_string(low) + "-" + std::to_string(2 * low - 1);
}

}  // namespace twintrace::probe
