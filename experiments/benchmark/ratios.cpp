#include "experiments/benchmark/ratios.h"

#include <algorithm>

namespace twintrace {
namespace {

/// What wide lanes promise, as multiples of other arms' rates.
struct WideBounds {
  InstructionSet set;
  double overScalar;
  double overGpu;
};
constexpr WideBounds kWideBounds[] = {{InstructionSet::avx512, 4.0, 1.3},
                                      {InstructionSet::avx2, 2.5, 0.85}};

class Rates {
 public:
  explicit Rates(const SceneTimes& times) : times_(times) {}

  std::optional<double> of(std::string_view arm, Clock clock) const {
    const ArmTimes* found = times_.find(arm);
    if (!found) return std::nullopt;
    return bestRate(*found, clock, times_.threads);
  }

  std::optional<double> bestGpu(Clock clock) const {
    std::optional<double> best;
    for (const auto arm : {kStrictFragment, kNativeFragment, kStrictCompute, kNativeCompute}) {
      best = std::max(best, of(arm, clock));
    }
    return best;
  }

 private:
  const SceneTimes& times_;
};

template <class Rate1, class Rate2>
Ratio ratio(std::string name, Rate1 above, Rate2 below, double bound, bool atMost = false) {
  const auto divide = [&](Clock clock) -> std::optional<double> {
    const std::optional<double> a = above(clock), b = below(clock);
    if (!a || !b) return std::nullopt;
    return *a / *b;
  };
  return {std::move(name), divide(Clock::wall), divide(Clock::cpu), bound, atMost};
}

}  // namespace

std::vector<Ratio> promisedRatios(const SceneTimes& times, InstructionSet best) {
  const Rates rates(times);
  const auto rate = [&rates](std::string_view arm) {
    return [&rates, arm](Clock clock) { return rates.of(arm, clock); };
  };
  const auto bestGpu = [&rates](Clock clock) { return rates.bestGpu(clock); };
  // A ratio of times is the inverse one of rates.
  std::vector<Ratio> ratios = {
      ratio("gpu time strict / native, fragment", rate(kNativeFragment), rate(kStrictFragment),
            1.10, true),
      ratio("gpu time strict / native, compute", rate(kNativeCompute), rate(kStrictCompute), 1.10,
            true),
      ratio("gpu specialised / all effects in buffers", rate(kStrictFragment), rate(kAllEffects),
            1.8),
      ratio("cpu scalar / best gpu", rate(kScalar), bestGpu, 0.25),
  };
  for (const WideBounds& bounds : kWideBounds) {
    if (bounds.set != best) continue;
    const std::string wide = wideArmName(best);
    ratios.push_back(ratio(wide + " / cpu scalar", rate(wide), rate(kScalar), bounds.overScalar));
    ratios.push_back(ratio(wide + " / best gpu", rate(wide), bestGpu, bounds.overGpu));
  }
  return ratios;
}

}  // namespace twintrace
