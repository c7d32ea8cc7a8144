#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/explain/divergence.h"
#include "experiments/explain/path_tracer.h"
#include "experiments/explain/vertices.h"

namespace twintrace {

/// What kind of difference a sample shows.
enum class DifferenceClass {
  rounding,
  branchFlip,
  otherPrimitive,
  lobeFlip,
  nan,
  lightLeak,
  unexplained
};
inline constexpr int kDifferenceClassCount = 7;

/// As in the JSON: rounding, branch_flip, other_primitive, lobe_flip, nan, light_leak, unexplained.
std::string_view className(DifferenceClass kind);

/// A sample, traced on both arms and compared. The trees are views: it can't be copied.
struct SampleExplanation {
  SampleExplanation() = default;
  SampleExplanation(const SampleExplanation&) = delete;
  SampleExplanation& operator=(const SampleExplanation&) = delete;

  CallTrace traceA;
  CallTrace traceB;
  CallTree treeA;
  CallTree treeB;
  bool sameRadiance = true;
  std::optional<Divergence> divergence;  ///< also where it left no trace in the radiance
  DifferenceClass kind = DifferenceClass::unexplained;  ///< meaningless if the radiance is the same
  std::vector<PathVertex> verticesA;
  std::vector<PathVertex> verticesB;
  int parted = -1;  ///< first vertex whose record differs; -1 = none

  /// The words in which the differing statement's values differ.
  std::vector<WordDifference> wordDifferences() const;
};

/// Traces a sample of a pixel on both arms into `result`, which must be fresh; the
/// tracers have to outlive it.
///
/// The class is the first discrete event, in the order of the path: a branch that the first differing
/// call takes otherwise, another primitive, a shadow ray with another answer (light leak), another
/// lobe, another end of the path (branch flip). Without one, a NaN on one side is nan; a first
/// difference within 2^-16 of the largest value that the call sees is rounding; all else is
/// unexplained.
void explainSample(PathTracer& a, PathTracer& b, const PixelPosition& pixel, std::uint32_t sample,
                   SampleExplanation& result);

/// The events, vertex by vertex, that follow a first difference, in words.
std::vector<std::string> consequences(const SampleExplanation& explanation);

}  // namespace twintrace
