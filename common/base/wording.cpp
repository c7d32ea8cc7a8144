#include "common/base/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "common/base/nearest.h"

namespace twintrace {

namespace {

constexpr std::size_t kMaxQuotedBytes = 60;
constexpr std::size_t kMaxListedWords = 30;
/// Names that a suggestion is chosen from; more would take long in a file with many faults.
constexpr std::size_t kMaxSuggested = 1000;

bool continuesCharacter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

std::string_view cutAtCharacter(std::string_view text, std::size_t length) {
  if (text.size() <= length) return text;
  while (length > 0 && continuesCharacter(text[length])) --length;
  return text.substr(0, length);
}

}  // namespace

std::string quote(std::string_view text) {
  const std::string_view shown = cutAtCharacter(text, kMaxQuotedBytes);
  std::string result = "'";
  for (const char byte : shown) {
    const auto code = static_cast<unsigned char>(byte);
    if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\x{:02x}", code);
    } else {
      result += byte;
    }
  }
  if (shown.size() < text.size()) result += "...";
  return result + "'";
}

std::string oneOf(std::span<const std::string> words) {
  const std::size_t shown = std::min(words.size(), kMaxListedWords);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  if (shown < words.size()) text += fmt::format(" or {} others", words.size() - shown);
  return text;
}

std::string didYouMean(std::string_view word, std::span<const std::string> candidates) {
  const auto near = nearest(word, candidates.first(std::min(candidates.size(), kMaxSuggested)));
  return near ? " (did you mean " + quote(*near) + "?)" : "";
}

std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? one : many);
}

}  // namespace twintrace
