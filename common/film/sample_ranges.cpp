#include "common/film/sample_ranges.h"

#include <algorithm>

#include "common/base/error.h"

namespace twintrace {
namespace {

std::string rangeText(const SampleRange& range) {
  std::string text = std::to_string(range.first);
  text += "-";
  return text += std::to_string(range.end() - 1);
}

void requireValid(const SampleRange& range) {
  constexpr std::uint64_t kLimit = std::uint64_t{1} << 32;
  if (range.count == 0)
    throw UsageError("found an empty sample range, expected at least one sample");
  if (range.first >= kLimit || range.count > kLimit - range.first) {
    throw UsageError("found samples from " + std::to_string(range.first) + ", " +
                     std::to_string(range.count) + " of them, expected indices below 2^32");
  }
}

}  // namespace

void SampleRanges::add(const SampleRange& range) {
  requireValid(range);
  auto next =
      std::lower_bound(ranges_.begin(), ranges_.end(), range.first,
                       [](const SampleRange& r, std::uint64_t first) { return r.end() <= first; });
  if (next != ranges_.end() && next->first < range.end()) {
    throw UsageError("samples " + rangeText(range) + " overlap samples " + rangeText(*next) +
                     " that the film already holds");
  }
  auto placed = ranges_.insert(next, range);
  if (placed + 1 != ranges_.end() && (placed + 1)->first == placed->end()) {
    placed->count += (placed + 1)->count;
    ranges_.erase(placed + 1);
  }
  if (placed != ranges_.begin() && (placed - 1)->end() == placed->first) {
    (placed - 1)->count += placed->count;
    ranges_.erase(placed);
  }
}

void SampleRanges::add(const SampleRanges& other) {
  SampleRanges merged = *this;
  for (const SampleRange& range : other.ranges_) merged.add(range);
  ranges_ = std::move(merged.ranges_);
}

std::uint64_t SampleRanges::sampleCount() const {
  std::uint64_t count = 0;
  for (const SampleRange& range : ranges_) count += range.count;
  return count;
}

std::string SampleRanges::toString() const {
  std::string text;
  for (const SampleRange& range : ranges_) {
    if (!text.empty()) text += ",";
    text += rangeText(range);
  }
  return text;
}

}  // namespace twintrace
