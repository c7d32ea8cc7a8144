#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace twintrace::probe {

/// Distances in ulp, counted by powers of two: 0, 1, 2-3, 4-7, ... and, last, answers that no
/// distance describes: NaN against a number, or other integers and truth values.
class UlpHistogram {
 public:
  static constexpr std::size_t kBinCount = 34;

  /// A distance as of ulpDistance(): 2^32 - 1 is none.
  void add(std::uint32_t ulps);

  std::size_t count(std::size_t bin) const { return counts_[bin]; }
  std::size_t total() const;
  std::uint32_t largest() const { return largest_; }

  /// Label of the smallest bin up to which that share of all distances lies; at least one distance.
  std::string within(double share) const;

  /// `0`, `1`, `2-3`, ..., `other`.
  static std::string label(std::size_t bin);

 private:
  std::array<std::size_t, kBinCount> counts_{};
  std::uint32_t largest_ = 0;
};

}  // namespace twintrace::probe
