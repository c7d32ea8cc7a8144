#include "experiments/cast/tally.h"

#include <algorithm>

namespace twintrace {
namespace {

void count(Counts& counts, const Judgement& judgement) {
  ++counts.rays;
  counts.falseMisses += judgement.finding == Finding::falseMiss;
  counts.falseHits += judgement.finding == Finding::falseHit;
  counts.wrongPrimitives += judgement.finding == Finding::wrongPrimitive;
  counts.wrongDistances += judgement.finding == Finding::wrongDistance;
  counts.wrongNormals += judgement.normalOff;
  counts.selfHits += judgement.finding == Finding::selfHit;
  counts.leaks += judgement.finding == Finding::leak;
}

}  // namespace

void Tally::add(const Judgement& judgement) {
  count(all_, judgement);
  if (judgement.counts) count(clean_, judgement);
  notNumbers_ += judgement.finding == Finding::notANumber;
  notStarted_ += judgement.finding == Finding::notStarted;
  if (judgement.comparable) {
    const auto distance = static_cast<float>(judgement.distanceError);
    errors_.push_back({distance, judgement.ulp, judgement.counts});
  }
}

template <class Value>
Spread Tally::spreadOf(bool cleanOnly, const Value& value) const {
  std::vector<double> values;
  for (const Error& error : errors_) {
    if (error.clean || !cleanOnly) values.push_back(value(error));
  }
  if (values.empty()) return {};
  const auto rank = static_cast<std::ptrdiff_t>(0.999 * double(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return {*std::max_element(values.begin() + rank, values.end()), values[std::size_t(rank)]};
}

Spread Tally::distanceErrors(bool cleanOnly) const {
  return spreadOf(cleanOnly, [](const Error& error) { return double(error.distance); });
}

Spread Tally::ulps(bool cleanOnly) const {
  return spreadOf(cleanOnly, [](const Error& error) { return double(error.ulp); });
}

}  // namespace twintrace
