#pragma once

#include <cstdint>
#include <vector>

#include "experiments/cast/judge.h"

namespace twintrace {

/// Counts of findings over some rays.
struct Counts {
  std::uint64_t rays = 0;
  std::uint64_t falseMisses = 0;
  std::uint64_t falseHits = 0;
  std::uint64_t wrongPrimitives = 0;
  std::uint64_t wrongDistances = 0;
  std::uint64_t wrongNormals = 0;
  std::uint64_t selfHits = 0;
  std::uint64_t leaks = 0;

  /// All but wrong normals.
  std::uint64_t wrongAnswers() const {
    return falseMisses + falseHits + wrongPrimitives + wrongDistances + selfHits + leaks;
  }
};

/// The largest of some values, and what 99.9 % of them stay within.
struct Spread {
  double most = 0;
  double usual = 0;
};

/// What became of one engine's answers.
class Tally {
 public:
  void add(const Judgement& judgement);

  const Counts& all() const { return all_; }
  const Counts& clean() const { return clean_; }  ///< rays that nothing excuses
  std::uint64_t notNumbers() const { return notNumbers_; }
  std::uint64_t notStarted() const { return notStarted_; }

  Spread distanceErrors(bool cleanOnly) const;
  Spread ulps(bool cleanOnly) const;

  /// Answers that nothing excuses: wrong on a clean ray, or not a number.
  std::uint64_t inexcusable() const {
    return clean_.wrongAnswers() + clean_.wrongNormals + notNumbers_;
  }

 private:
  struct Error {
    float distance;
    std::uint32_t ulp;
    bool clean;
  };

  template <class Value>
  Spread spreadOf(bool cleanOnly, const Value& value) const;

  Counts all_;
  Counts clean_;
  std::uint64_t notNumbers_ = 0;
  std::uint64_t notStarted_ = 0;
  std::vector<Error> errors_;
};

}  // namespace twintrace
