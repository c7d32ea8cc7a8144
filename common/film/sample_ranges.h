#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace twintrace {

/// Samples first .. first + count - 1.
struct SampleRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;

  std::uint64_t end() const { return first + count; }
  bool operator==(const SampleRange&) const = default;
};

/// A set of sample indices below 2^32, kept as sorted ranges that neither overlap nor touch.
class SampleRanges {
 public:
  /// Adds a range. @throws UsageError if it is empty, ends beyond 2^32 or overlaps one already in
  /// the set, which it names; the set is unchanged then.
  void add(const SampleRange& range);

  /// Adds every range of another set, or none: throws as above.
  void add(const SampleRanges& other);

  const std::vector<SampleRange>& list() const { return ranges_; }

  /// Number of samples in the set.
  std::uint64_t sampleCount() const;

  /// "0-63,128-191", both ends included; empty for the empty set.
  std::string toString() const;

  bool operator==(const SampleRanges&) const = default;

 private:
  std::vector<SampleRange> ranges_;
};

}  // namespace twintrace
