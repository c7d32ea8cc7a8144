#include "experiments/explain/call_tree.h"

#include <bit>
#include <limits>

#include "common/base/float_bits.h"

namespace twintrace {
namespace {

void findBelow(const CallTree& tree, int from, std::string_view function, std::vector<int>& found) {
  if (tree.name(from) == function) {
    found.push_back(from);
    return;
  }
  for (const int child : tree.calls[static_cast<std::size_t>(from)].children) {
    findBelow(tree, child, function, found);
  }
}

}  // namespace

std::string_view CallTree::name(int call) const {
  const int function = calls[static_cast<std::size_t>(call)].function;
  if (function < 0) return "sample";
  return program->functions[static_cast<std::size_t>(function)].name;
}

std::vector<int> CallTree::find(int from, std::string_view function) const {
  std::vector<int> found;
  findBelow(*this, from, function, found);
  return found;
}

CallTree buildCallTree(const TraceProgram& program, const CallTrace& trace) {
  CallTree tree{&program, std::vector<Call>(1)};
  std::vector<int> open = {0};
  std::size_t at = 0;
  while (at < trace.words.size()) {
    const TraceSite& site = program.sites[trace.words[at]];
    const TracedValues values{&site, std::span(trace.words).subspan(at + 1, site.slots.size())};
    at += 1 + site.slots.size();
    const auto current = static_cast<std::size_t>(open.back());
    if (site.kind == TraceSite::Kind::enter) {
      const auto number = static_cast<int>(tree.calls.size());
      tree.calls[current].children.push_back(number);
      tree.calls.push_back({site.function, values, {}, {}, {}});
      open.push_back(number);
    } else if (site.kind == TraceSite::Kind::leave) {
      tree.calls[current].output = values;
      if (open.size() > 1) open.pop_back();
    } else {
      tree.calls[current].locals.push_back(values);
    }
  }
  return tree;
}

bool sameWord(WordKind kind, std::uint32_t a, std::uint32_t b) {
  if (kind != WordKind::real) return a == b;
  return sameBits(std::bit_cast<float>(a), std::bit_cast<float>(b));
}

bool sameValues(const TracedValues& a, const TracedValues& b) {
  if (a.words.size() != b.words.size()) return false;
  for (std::size_t i = 0; i < a.words.size(); ++i) {
    if (!sameWord(a.site->slots[i].kind, a.words[i], b.words[i])) return false;
  }
  return true;
}

std::optional<std::uint32_t> wordOf(const TracedValues& values, std::string_view path) {
  for (std::size_t i = 0; i < values.words.size(); ++i) {
    if (values.site->slots[i].path == path) return values.words[i];
  }
  return std::nullopt;
}

float realOf(const TracedValues& values, std::string_view path) {
  const auto word = wordOf(values, path);
  return word ? std::bit_cast<float>(*word) : std::numeric_limits<float>::quiet_NaN();
}

std::array<float, 3> vectorOf(const TracedValues& values, const std::string& path) {
  return {realOf(values, path + ".x"), realOf(values, path + ".y"), realOf(values, path + ".z")};
}

}  // namespace twintrace
