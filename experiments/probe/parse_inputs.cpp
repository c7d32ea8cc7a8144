#include <bit>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "experiments/probe/report.h"

namespace twintrace::probe {
namespace {

struct Word {
  std::string name;
  Kind kind;
};

std::vector<Word> wordsOf(const ShaderFunction& function) {
  std::vector<Word> words;
  for (const Slot& slot : function.inputs) {
    for (int i = 0; i < slot.size; ++i) {
      const std::string name = slot.path;
      words.push_back({slot.size == 1 ? name : name + "." + "xyzw"[i], slot.kind});
    }
  }
  return words;
}

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  if (text.ends_with(',')) parts.emplace_back();
  return parts;
}

std::optional<std::uint32_t> parseInteger(const std::string& text) {
  char* end = nullptr;
  const long long value = std::strtoll(text.c_str(), &end, 0);
  const bool whole = !text.empty() && *end == '\0';
  if (!whole || value < std::numeric_limits<std::int32_t>::min() ||
      value > std::numeric_limits<std::uint32_t>::max()) {
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(value);
}

std::optional<std::uint32_t> parseReal(const std::string& text) {
  const bool isBits = text.starts_with("0x") && text.find_first_of(".pP") == std::string::npos;
  if (isBits) return parseInteger(text);
  char* end = nullptr;
  const float value = std::strtof(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return std::bit_cast<std::uint32_t>(value);
}

std::optional<std::uint32_t> parseWord(Kind kind, const std::string& text) {
  if (kind == Kind::real) return parseReal(text);
  if (kind != Kind::truth) return parseInteger(text);
  if (text == "true" || text == "1" || text == "0x00000001") return 1u;
  if (text == "false" || text == "0" || text == "0x00000000") return 0u;
  return std::nullopt;
}

const char* expectedOf(Kind kind) {
  switch (kind) {
    case Kind::real:
      return "a float as a number or by its bits, such as 1.5, 0x1.8p0 or 0x3fc00000";
    case Kind::integer:
    case Kind::natural:
      return "a 32-bit integer";
    case Kind::truth:
      return "true or false";
  }
  return "";
}

}  // namespace

std::vector<std::uint32_t> parseInputs(const ShaderFunction& function, const std::string& text) {
  const std::vector<Word> words = wordsOf(function);
  const std::vector<std::string> parts = splitAtCommas(text);
  if (parts.size() != words.size()) {
    std::string names;
    for (const Word& word : words) names += (names.empty() ? "" : ",") + word.name;
    throw UsageError("inputs: found " + std::to_string(parts.size()) + " values, expected the " +
                     std::to_string(words.size()) + " of " + function.signature + ": " + names);
  }
  std::vector<std::uint32_t> inputs;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto word = parseWord(words[i].kind, parts[i]);
    if (!word) {
      throw UsageError("inputs: " + words[i].name + ": found " + quote(parts[i]) + ", expected " +
                       expectedOf(words[i].kind));
    }
    inputs.push_back(*word);
  }
  if (inputs.empty()) inputs.push_back(0u);
  return inputs;
}

}  // namespace twintrace::probe
