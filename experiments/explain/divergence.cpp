#include "experiments/explain/divergence.h"

#include <bit>
#include <deque>
#include <map>
#include <set>
#include <string_view>

namespace twintrace {
namespace {

using Names = std::set<std::string_view>;

Names namesOf(const TraceProgram& program) {
  Names names;
  for (const TraceFunction& function : program.functions) names.insert(function.name);
  return names;
}

/// A word such that sameWord is equality.
std::uint32_t canonical(WordKind kind, std::uint32_t word) {
  if (kind != WordKind::real) return word;
  const float value = std::bit_cast<float>(word);
  if (value != value) return 0x7fc00000u;
  return value == 0.0f ? 0u : word;
}

using Key = std::pair<std::string_view, std::vector<std::uint32_t>>;

Key keyOf(const CallTree& tree, int call) {
  const TracedValues& inputs = tree.calls[static_cast<std::size_t>(call)].inputs;
  Key key{tree.name(call), {}};
  for (std::size_t i = 0; i < inputs.words.size(); ++i) {
    key.second.push_back(canonical(inputs.site->slots[i].kind, inputs.words[i]));
  }
  return key;
}

class Search {
 public:
  Search(const CallTree& a, const CallTree& b)
      : a_(a), b_(b), namesA_(namesOf(*a.program)), namesB_(namesOf(*b.program)) {}

  /// The innermost divergence below two calls, or nothing if all that match agree.
  std::optional<Divergence> below(int a, int b) const {
    std::map<Key, std::deque<int>> candidates;
    for (const int child : children(b_, b, namesA_)) candidates[keyOf(b_, child)].push_back(child);
    int step = -2;  // the first child of the sample is the camera ray
    for (const int child : children(a_, a, namesB_)) {
      ++step;
      const auto found = candidates.find(keyOf(a_, child));
      if (found == candidates.end() || found->second.empty()) continue;
      const int partner = found->second.front();
      found->second.pop_front();
      if (sameValues(callA(child).output, callB(partner).output)) continue;
      const auto inner = below(child, partner);
      // An output is missing where a trace had no room.
      const bool isComplete = callA(child).output.site && callB(partner).output.site;
      if (!inner && !isComplete) continue;
      Divergence result =
          inner ? *inner
                : Divergence{child, partner, -1,
                             firstDifferingStatement(*a_.program, callA(child), *b_.program,
                                                     callB(partner))};
      if (a == 0) result.step = step;
      return result;
    }
    return std::nullopt;
  }

 private:
  const Call& callA(int call) const { return a_.calls[static_cast<std::size_t>(call)]; }
  const Call& callB(int call) const { return b_.calls[static_cast<std::size_t>(call)]; }

  /// The children that the other side may have too; in the place of others, their children.
  static std::vector<int> children(const CallTree& tree, int call, const Names& others) {
    std::vector<int> shared;
    for (const int child : tree.calls[static_cast<std::size_t>(call)].children) {
      if (others.contains(tree.name(child))) {
        shared.push_back(child);
      } else {
        for (const int inner : children(tree, child, others)) shared.push_back(inner);
      }
    }
    return shared;
  }

  const CallTree& a_;
  const CallTree& b_;
  Names namesA_;
  Names namesB_;
};

}  // namespace

std::optional<Divergence> firstDivergence(const CallTree& a, const CallTree& b) {
  return Search(a, b).below(0, 0);
}

}  // namespace twintrace
