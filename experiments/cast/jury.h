#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/cast/case_set.h"
#include "common/cast/exact_hit.h"
#include "common/cast/families.h"
#include "experiments/cast/tally.h"

namespace twintrace {

/// An engine before the jury.
struct JuryEngine {
  std::string label;     ///< such as gpu or cpu/report
  bool trusted = false;  ///< its errors fail the check
  bool listed = false;   ///< its errors are kept for lists and files
  std::unique_ptr<CaseEngine> engine;
};

/// What one engine made of a set of cases.
struct EngineVerdict {
  std::string label;
  bool trusted = false;
  Tally tally;  ///< of the rays that it could be asked
};

/// A ray on which engines went wrong, with all that is needed to ask again.
struct Disagreement {
  std::string scene;
  std::string ray;
  std::vector<CasePrimitive> primitives;
  std::vector<std::string> primitiveNames;
  CastRay cast;
  std::optional<ExactHit> exact;      ///< nothing for bounces
  std::vector<CastHit> answers;       ///< by engine
  std::vector<Judgement> judgements;  ///< by engine
};

/// The findings on one set of cases: a family, a file or a scene.
struct JuryReport {
  std::string name;
  std::string what;
  bool bounces = false;
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;  ///< this and what follows in exact arithmetic; 0 for bounces
  std::uint64_t clean = 0;
  std::uint64_t ambiguous = 0;
  std::uint64_t ties = 0;
  std::uint64_t unanswerable = 0;  ///< rays with a NaN
  std::vector<EngineVerdict> engines;
  std::uint64_t twinsCompared = 0;
  /// Rays on which gpu and cpu differ in a bit, with either intersector.
  std::uint64_t twinsDiffer = 0;
  std::vector<Disagreement> disagreements;

  /// Whether a trusted engine has an inexcusable answer, or the twins differ.
  bool failed() const;
};

/// Puts cases before engines and exact arithmetic.
class Jury {
 public:
  /// @param keep disagreements kept per report
  Jury(std::vector<JuryEngine>& engines, std::size_t keep) : engines_(engines), keep_(keep) {}

  /// Begins a report on cases of this name.
  JuryReport open(const std::string& name, const std::string& what) const;

  /// Casts the cases and adds what comes out.
  /// @param firstRay number of the first ray, as its name where it has none
  void hear(JuryReport& report, const CaseSet& cases, Expectation expectation,
            std::uint64_t firstRay = 0);

 private:
  std::vector<JuryEngine>& engines_;
  std::size_t keep_;
};

/// The answer of exact arithmetic as engines give theirs.
CastHit asAnswer(const ExactHit& exact);

/// Disagreements as cases that can be asked again, ray by ray in the same order.
CaseSet casesOf(const std::vector<Disagreement>& disagreements);

}  // namespace twintrace
