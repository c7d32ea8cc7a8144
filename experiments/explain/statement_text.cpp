#include "experiments/explain/statement_text.h"

#include <fmt/format.h>

#include <bit>

#include "common/base/float_bits.h"

namespace twintrace {
namespace {

std::uint32_t ulpOf(const WordDifference& word) {
  return ulpDistance(std::bit_cast<float>(word.a), std::bit_cast<float>(word.b));
}

std::string suspectsText(const std::vector<TracedValues>& suspects, const std::string& side) {
  if (suspects.empty()) return "";
  std::string text = fmt::format(
      "  it is made of statements of {} that the other side does not have; it may be one of them\n",
      side);
  for (const TracedValues& suspect : suspects) {
    text += fmt::format("    {}  {}\n", suspect.site->place, suspect.site->text);
    for (std::size_t i = 0; i < suspect.words.size(); ++i) {
      const TraceSlot& slot = suspect.site->slots[i];
      text += fmt::format("      {:<22} {}\n", slot.path, wordText(slot.kind, suspect.words[i]));
    }
  }
  return text;
}

Json sideJson(const TracedValues& statement, const std::vector<TracedValues>& suspects) {
  Json list = Json::array();
  for (const TracedValues& suspect : suspects) {
    Json values = Json::object();
    for (std::size_t i = 0; i < suspect.words.size(); ++i) {
      const TraceSlot& slot = suspect.site->slots[i];
      values[slot.path] = wordJson(slot.kind, suspect.words[i]);
    }
    list.push_back(
        {{"place", suspect.site->place}, {"text", suspect.site->text}, {"values", values}});
  }
  return {{"place", statement.site->place}, {"text", statement.site->text}, {"suspects", list}};
}

}  // namespace

std::string wordText(WordKind kind, std::uint32_t word) {
  switch (kind) {
    case WordKind::real:
      return fmt::format("{:a} ({:.9g})", std::bit_cast<float>(word), std::bit_cast<float>(word));
    case WordKind::integer:
      return std::to_string(static_cast<std::int32_t>(word));
    case WordKind::truth:
      return word != 0 ? "true" : "false";
    case WordKind::natural:
      break;
  }
  return fmt::format("0x{:08x}", word);
}

Json wordJson(WordKind kind, std::uint32_t word) {
  if (kind == WordKind::real) {
    const auto value = std::bit_cast<float>(word);
    return {{"value", value},
            {"hex", fmt::format("{:a}", value)},
            {"bits", fmt::format("0x{:08x}", word)}};
  }
  return {{"value", wordText(kind, word)}, {"bits", fmt::format("0x{:08x}", word)}};
}

std::string statementText(const StatementDifference& statement, const SideNames& names) {
  const std::size_t width = std::max(names.a.size(), names.b.size());
  const auto line = [&](const std::string& name, const TracedValues& side) {
    return fmt::format("    {:<{}} {}  {}\n", name, width, side.site->place, side.site->text);
  };
  std::string text =
      "  first differing statement\n" + line(names.a, statement.a) + line(names.b, statement.b);
  for (const WordDifference& word : wordDifferences(statement)) {
    text +=
        fmt::format("    {:<24} {:<{}} {}\n    {:<24} {:<{}} {}", word.path, names.a, width,
                    wordText(word.kind, word.a), "", names.b, width, wordText(word.kind, word.b));
    text += word.kind == WordKind::real ? fmt::format("  {} ulp\n", ulpOf(word)) : "\n";
  }
  return text + suspectsText(statement.suspectsA, names.a) +
         suspectsText(statement.suspectsB, names.b);
}

Json statementJson(const StatementDifference& statement, const SideNames& names) {
  return {{names.a, sideJson(statement.a, statement.suspectsA)},
          {names.b, sideJson(statement.b, statement.suspectsB)}};
}

Json differingJson(const StatementDifference& statement, const SideNames& names) {
  Json differing = Json::array();
  for (const WordDifference& word : wordDifferences(statement)) {
    differing.push_back({{"variable", word.path},
                         {names.a, wordJson(word.kind, word.a)},
                         {names.b, wordJson(word.kind, word.b)},
                         {"ulp", word.kind == WordKind::real ? Json(ulpOf(word)) : Json(nullptr)}});
  }
  return differing;
}

}  // namespace twintrace
