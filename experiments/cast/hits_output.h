#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "common/cast/case_set.h"
#include "experiments/cast/jury.h"

namespace twintrace {

/// Which of the two hits files.
enum class HitsFormat { rays, cases };

/// Writes the answers of engines to rays as a Hits CSV or the hits of cases, engine by engine.
class HitsOutput {
 public:
  HitsOutput(std::ostream& out, HitsFormat format);

  /// One engine's answers.
  void write(const CaseSet& cases, const std::string& engine, const std::vector<CastHit>& answers);

  /// The answers of exact arithmetic, with their classes.
  void write(const CaseSet& cases, const std::vector<ExactHit>& exact);

  /// All answers to each disagreement, exact arithmetic first.
  void write(const JuryReport& report);

 private:
  std::ostream& out_;
  HitsFormat format_;
};

}  // namespace twintrace
