#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/film/image_io.h"
#include "common/stats/compare_bits.h"
#include "common/stats/equivalence.h"
#include "common/stats/family_test.h"
#include "common/stats/verdict.h"

namespace twintrace {

struct ComparisonSettings {
  double alpha = kEquivalenceAlpha;  ///< of the family test and of the equivalence test
  double bound = kEquivalenceBound;  ///< relative difference of means that counts as equal
  int repeats = 1;                   ///< timed runs of each arm; the fastest counts
};

/// @throws UsageError unless 0 < alpha < 1, 0 < bound < 1 and repeats > 0.
void checkSettings(const ComparisonSettings& settings);

/// Where two pictures part, first in row order.
struct FirstDifference {
  PixelPosition pixel;
  std::optional<std::int64_t> sample;  ///< the first that differs there, if it was found
  std::array<float, 3> a{};            ///< value of that sample, else of the picture
  std::array<float, 3> b{};
};

/// How much of a difference is of one class.
struct DifferenceShare {
  double pixels = 0;  ///< of the pixels examined, 0..1
  double energy = 0;  ///< of the sum of their absolute differences, 0..1
};

/// The classes of differences between paired arms.
struct DifferenceShares {
  int examined = 0;  ///< differing pixels that were explained
  std::map<std::string, DifferenceShare> byClass;
};

/// What the comparison of two pictures found, whether rendered or read.
struct Comparison {
  Verdict verdict = Verdict::inconclusive;
  bool paired = false;
  BitComparison bits;  ///< of the pictures; films decide where there are any
  std::int64_t differingPixels = 0;
  std::optional<FirstDifference> first;
  FamilyTest family;                ///< of unpaired pictures only
  std::uint64_t droppedFrames = 0;  ///< of pixels, left out of the tested batches of both arms
  Equivalence equivalence;
  /// Of the z map; NaN if no errors are known. For paired pictures, whose noise is not independent,
  /// z is too small and only a map.
  double zRejectedFraction = 0;
  std::vector<std::string> notes;  ///< what a reader of the verdict has to know

  ExrContent a;
  ExrContent b;
  Image z;  ///< empty if no errors are known
  std::vector<float> ulp;
  DifferenceShares classes;
  /// Of the pixels that were explained the vertex of the path where the arms part, else -1; empty if
  /// none was explained.
  std::vector<float> divergeBounce;
};

/// Compares two pictures by value and draws the maps; verdict and tests are left to the caller.
/// @throws UsageError with both sizes if they differ.
Comparison comparePictures(ExrContent a, ExrContent b);

/// Adds the z map. @throws UsageError if the sizes differ.
void addZMap(Comparison& comparison, const ImageEstimate& a, const ImageEstimate& b);

/// For unpaired pictures of the same seed and noise: samples in common correlate them, so that
/// their difference varies less than the tests assume.
inline constexpr const char* kSharedSeedNote =
    "the pictures share their seed; the tests take them as independent and are less sensitive "
    "where samples are in common";

/// False discovery rate of the z map's rejected fraction.
inline constexpr double kZMapRate = 0.01;

}  // namespace twintrace
