#include "experiments/explain/statements.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "common/base/word_char.h"

namespace twintrace {
namespace {

using Names = std::set<std::string_view>;

/// The variable that a local's slots belong to.
std::string_view variableOf(const TraceSite& local) {
  const std::string_view path = local.slots.front().path;
  return path.substr(0, path.find('.'));
}

/// In how many statements a function gives a value to each of its variables.
std::map<std::string_view, int> assignments(const TraceProgram& program, int function) {
  std::map<std::string_view, int> counts;
  for (const TraceSite& site : program.sites) {
    if (site.function == function && site.kind == TraceSite::Kind::local)
      ++counts[variableOf(site)];
  }
  return counts;
}

/// The names in a text, without those of members.
Names namesIn(std::string_view text) {
  Names names;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && isWordChar(text[end])) ++end;
    if (end > at && (at == 0 || text[at - 1] != '.')) names.insert(text.substr(at, end - at));
    at = std::max(end, at + 1);
  }
  return names;
}

/// The names that a statement's value is made of: with its own variable if it changes only a part.
Names namesUsed(const TracedValues& statement) {
  const std::string_view text = statement.site->text;
  const std::size_t equals = text.find('=');
  const bool isLocal = statement.site->kind == TraceSite::Kind::local;
  if (!isLocal || equals == std::string_view::npos || equals == 0) return namesIn(text);
  const bool replaces = text[equals - 1] == ' ' && text.substr(0, equals).find('.') == text.npos;
  return namesIn(replaces ? text.substr(equals) : text);
}

/// The variable that `return NAME;` returns, or an empty name.
std::string_view returned(const TracedValues& output) {
  constexpr std::string_view kReturn = "return ";
  if (output.site == nullptr) return {};
  std::string_view text = output.site->text;
  if (!text.starts_with(kReturn) || !text.ends_with(";")) return {};
  text = text.substr(kReturn.size(), text.size() - kReturn.size() - 1);
  return std::ranges::all_of(text, isWordChar) ? text : std::string_view();
}

/// One side of a comparison.
class Side {
 public:
  Side(const TraceProgram& program, const Call& call)
      : call_(call), assigned_(assignments(program, call.function)) {}

  const Call& call() const { return call_; }

  bool shares(std::string_view name, const Side& other) const {
    const auto own = assigned_.find(name);
    const auto others = other.assigned_.find(name);
    return own != assigned_.end() && others != other.assigned_.end() &&
           own->second == others->second;
  }

  /// The statement to which the result owes the words in which it differs from the other's.
  TracedValues originOfResult(const Side& other) const {
    const std::string_view name = resultName(other);
    TracedValues origin = call_.output;
    for (auto local = call_.locals.rbegin(); local != call_.locals.rend(); ++local) {
      if (variableOf(*local->site) != name) continue;
      if (!hasWrongWords(*local, other.call_.output)) break;
      origin = *local;
    }
    return origin;
  }

  /// The statements that one is made of and that can't be compared, in the order of execution.
  std::vector<TracedValues> suspects(const TracedValues& differing, const Side& other) const {
    std::vector<TracedValues> found;
    if (differing.site == nullptr) return found;
    const std::string_view result = resultName(other);
    Names wanted = namesUsed(differing);
    for (auto local = before(differing); local != call_.locals.rend(); ++local) {
      const std::string_view name = variableOf(*local->site);
      if (shares(name, other) || wanted.erase(name) == 0) continue;
      if (name == result && sameResult(*local, other.call_.output)) continue;
      found.push_back(*local);
      wanted.merge(namesUsed(*local));
    }
    std::ranges::reverse(found);
    return found;
  }

 private:
  /// The variable that is returned as it is, if the other side lacks it.
  std::string_view resultName(const Side& other) const {
    const std::string_view name = returned(call_.output);
    return shares(name, other) ? std::string_view() : name;
  }

  static bool sameResult(const TracedValues& local, const TracedValues& output) {
    return !local.words.empty() && sameValues(local, output);
  }

  /// Whether a value has the result's words wherever that differs from the other's.
  bool hasWrongWords(const TracedValues& local, const TracedValues& otherOutput) const {
    const TracedValues& own = call_.output;
    const std::size_t count = own.words.size();
    if (local.words.size() != count || otherOutput.words.size() != count) return false;
    for (std::size_t i = 0; i < count; ++i) {
      const WordKind kind = own.site->slots[i].kind;
      if (sameWord(kind, own.words[i], otherOutput.words[i])) continue;
      if (!sameWord(kind, own.words[i], local.words[i])) return false;
    }
    return true;
  }

  /// From the last local before a statement backwards.
  std::vector<TracedValues>::const_reverse_iterator before(const TracedValues& statement) const {
    return std::find_if(call_.locals.rbegin(), call_.locals.rend(), [&](const TracedValues& local) {
      return local.words.data() < statement.words.data();
    });
  }

  const Call& call_;
  std::map<std::string_view, int> assigned_;
};

/// The first pair of corresponding locals that differ; without one, what the results came from.
StatementDifference differingPair(const Side& a, const Side& b) {
  std::map<std::string_view, std::deque<const TracedValues*>> partners;
  for (const TracedValues& local : b.call().locals) {
    partners[variableOf(*local.site)].push_back(&local);
  }
  for (const TracedValues& local : a.call().locals) {
    const std::string_view name = variableOf(*local.site);
    auto& next = partners[name];
    if (!a.shares(name, b) || next.empty()) continue;
    const TracedValues& partner = *next.front();
    next.pop_front();
    if (local.words.size() == partner.words.size() && !sameValues(local, partner)) {
      return {local, partner, {}, {}};
    }
  }
  return {a.originOfResult(b), b.originOfResult(a), {}, {}};
}

}  // namespace

StatementDifference firstDifferingStatement(const TraceProgram& programA, const Call& a,
                                            const TraceProgram& programB, const Call& b) {
  const Side sideA(programA, a);
  const Side sideB(programB, b);
  StatementDifference found = differingPair(sideA, sideB);
  found.suspectsA = sideA.suspects(found.a, sideB);
  found.suspectsB = sideB.suspects(found.b, sideA);
  return found;
}

std::vector<WordDifference> wordDifferences(const StatementDifference& statement) {
  const TracedValues& a = statement.a;
  const TracedValues& b = statement.b;
  std::vector<WordDifference> words;
  for (std::size_t i = 0; i < std::min(a.words.size(), b.words.size()); ++i) {
    const TraceSlot& slot = a.site->slots[i];
    if (sameWord(slot.kind, a.words[i], b.words[i])) continue;
    words.push_back({slot.path, slot.kind, a.words[i], b.words[i]});
  }
  return words;
}

}  // namespace twintrace
