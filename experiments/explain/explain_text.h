#pragma once

#include <string>
#include <vector>

#include "common/scene/flat_scene.h"
#include "experiments/explain/explanation.h"
#include "experiments/results_json.h"

namespace twintrace {

/// What an explanation is about, besides the explanation itself.
struct ExplainedSample {
  PixelPosition pixel;
  std::int64_t sample = 0;
  std::vector<std::string> notes;  ///< what a reader has to know
  /// The command that runs the first differing call alone; empty if there is none.
  std::string replay;
  /// Whether the arms' plain programs, those without tracing, render the sample alike.
  bool renderedAlike = true;
};

/// For people: the path on both arms, the first differing operation, and what followed.
std::string explanationText(const FlatScene& scene, const ExplainedSample& about,
                            const SampleExplanation& explanation);

/// The same as JSON: `x`, `y`, `sample`, `identical` (on plain and on traced programs), `radiance_a`,
/// `radiance_b`, `class` (null if the traced ones agree), `first` {`function`, ...}, `parted_at_vertex`,
/// `consequences`, `vertices_a`, `vertices_b`, `notes`.
Json explanationJson(const FlatScene& scene, const ExplainedSample& about,
                     const SampleExplanation& explanation);

}  // namespace twintrace
