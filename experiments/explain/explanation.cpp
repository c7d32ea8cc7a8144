#include "experiments/explain/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "common/base/float_bits.h"

namespace twintrace {
namespace {

/// How far rounding, magnified within one call, can move a result: some hundred ulp.
constexpr double kRoundingBound = 0x1p-16;

const Call& callAt(const CallTree& tree, int call) {
  return tree.calls[static_cast<std::size_t>(call)];
}

bool sameVector(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return sameBits(a[0], b[0]) && sameBits(a[1], b[1]) && sameBits(a[2], b[2]);
}

bool anyNan(const std::array<float, 3>& v) {
  return std::isnan(v[0]) || std::isnan(v[1]) || std::isnan(v[2]);
}

bool sameVertex(const PathVertex& a, const PathVertex& b) {
  return sameVector(a.origin, b.origin) && sameVector(a.direction, b.direction) &&
         a.primitive == b.primitive && sameBits(a.t, b.t) && sameVector(a.normal, b.normal) &&
         a.noise == b.noise && a.blocked == b.blocked && a.lobe == b.lobe &&
         sameVector(a.throughput, b.throughput) && sameVector(a.radiance, b.radiance) &&
         a.alive == b.alive;
}

int firstParted(const std::vector<PathVertex>& a, const std::vector<PathVertex>& b) {
  const std::size_t common = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (!sameVertex(a[i], b[i])) return static_cast<int>(i);
  }
  return a.size() == b.size() ? -1 : static_cast<int>(common);
}

/// The first discrete difference of two vertices, if there is one.
std::optional<DifferenceClass> discreteEvent(const PathVertex& a, const PathVertex& b) {
  if (a.primitive != b.primitive) return DifferenceClass::otherPrimitive;
  if (a.blocked != b.blocked) return DifferenceClass::lightLeak;
  if (a.lobe != b.lobe) return DifferenceClass::lobeFlip;
  if (a.alive != b.alive) return DifferenceClass::branchFlip;
  return std::nullopt;
}

/// How many choices a call made, and how many for the first alternative.
struct Choices {
  int made = 0;
  int first = 0;
};

Choices choicesOf(const CallTree& tree, int call) {
  Choices choices;
  for (const int child : callAt(tree, call).children) {
    const auto condition = wordOf(callAt(tree, child).inputs, "condition");
    if (tree.name(child) != "select" || !condition) continue;
    ++choices.made;
    choices.first += *condition != 0 ? 1 : 0;
  }
  return choices;
}

bool differsInTruth(const StatementDifference& statement) {
  for (std::size_t i = 0; i < std::min(statement.a.words.size(), statement.b.words.size()); ++i) {
    const WordKind kind = statement.a.site->slots[i].kind;
    if (kind == WordKind::truth && statement.a.words[i] != statement.b.words[i]) return true;
  }
  return false;
}

/// Whether the first differing call itself goes another way.
bool branches(const SampleExplanation& e) {
  const Choices a = choicesOf(e.treeA, e.divergence->a);
  const Choices b = choicesOf(e.treeB, e.divergence->b);
  return differsInTruth(e.divergence->statement) || (a.made == b.made && a.first != b.first);
}

double largestReal(const TracedValues& values) {
  double largest = 0;
  for (std::size_t i = 0; i < values.words.size(); ++i) {
    if (values.site->slots[i].kind != WordKind::real) continue;
    const double size = std::fabs(std::bit_cast<float>(values.words[i]));
    if (std::isfinite(size) && size < std::numeric_limits<float>::max()) {
      largest = std::max(largest, size);
    }
  }
  return largest;
}

bool isRounding(const SampleExplanation& e) {
  const Call& call = callAt(e.treeA, e.divergence->a);
  const double scale = std::max(largestReal(call.inputs), largestReal(call.output));
  for (const WordDifference& word : e.wordDifferences()) {
    if (word.kind != WordKind::real) return false;
    const double difference =
        std::fabs(double{std::bit_cast<float>(word.a)} - double{std::bit_cast<float>(word.b)});
    if (!(difference <= kRoundingBound * scale)) return false;
  }
  return true;
}

/// Functions whose own choice is a hit or a lobe, and not a branch of its own kind.
bool choosesHitOrLobe(std::string_view function) {
  return function == "nearer" || function == "visitGeometry" || function == "closestHit" ||
         function == "occluded" || function == "sampleScattering" || function == "chosenScatter";
}

DifferenceClass classify(const SampleExplanation& e) {
  if (!e.divergence) return DifferenceClass::unexplained;
  if (anyNan(e.traceA.radiance) != anyNan(e.traceB.radiance)) return DifferenceClass::nan;
  if (branches(e) && !choosesHitOrLobe(e.treeA.name(e.divergence->a))) {
    return DifferenceClass::branchFlip;
  }
  const std::size_t common = std::min(e.verticesA.size(), e.verticesB.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (const auto event = discreteEvent(e.verticesA[i], e.verticesB[i])) return *event;
  }
  return isRounding(e) ? DifferenceClass::rounding : DifferenceClass::unexplained;
}

}  // namespace

std::string_view className(DifferenceClass kind) {
  switch (kind) {
    case DifferenceClass::rounding:
      return "rounding";
    case DifferenceClass::branchFlip:
      return "branch_flip";
    case DifferenceClass::otherPrimitive:
      return "other_primitive";
    case DifferenceClass::lobeFlip:
      return "lobe_flip";
    case DifferenceClass::nan:
      return "nan";
    case DifferenceClass::lightLeak:
      return "light_leak";
    case DifferenceClass::unexplained:
      break;
  }
  return "unexplained";
}

std::vector<WordDifference> SampleExplanation::wordDifferences() const {
  if (!divergence) return {};
  return twintrace::wordDifferences(divergence->statement);
}

void explainSample(PathTracer& a, PathTracer& b, const PixelPosition& pixel, std::uint32_t sample,
                   SampleExplanation& result) {
  result.traceA = a.trace(pixel, sample);
  result.traceB = b.trace(pixel, sample);
  result.treeA = buildCallTree(a.program(), result.traceA);
  result.treeB = buildCallTree(b.program(), result.traceB);
  result.sameRadiance = sameVector(result.traceA.radiance, result.traceB.radiance);
  result.divergence = firstDivergence(result.treeA, result.treeB);
  result.verticesA = pathVertices(result.treeA);
  result.verticesB = pathVertices(result.treeB);
  result.parted = firstParted(result.verticesA, result.verticesB);
  result.kind = classify(result);
}

std::vector<std::string> consequences(const SampleExplanation& e) {
  std::vector<std::string> events;
  const auto count = [](const std::vector<PathVertex>& v) { return static_cast<int>(v.size()); };
  const int common = std::min(count(e.verticesA), count(e.verticesB));
  for (int i = std::max(e.parted, 0); i < common; ++i) {
    const auto event = discreteEvent(e.verticesA[static_cast<std::size_t>(i)],
                                     e.verticesB[static_cast<std::size_t>(i)]);
    if (event) events.push_back(fmt::format("vertex {}: {}", i, className(*event)));
  }
  if (count(e.verticesA) != count(e.verticesB)) {
    events.push_back(fmt::format("the path of a has {} vertices, that of b {}", count(e.verticesA),
                                 count(e.verticesB)));
  }
  if (e.parted >= 0 && events.empty()) {
    events.emplace_back(
        "only numbers differ: the same primitives, lobes and shadows on both sides");
  }
  return events;
}

}  // namespace twintrace
