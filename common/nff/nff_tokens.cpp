#include "common/nff/nff_tokens.h"

#include <charconv>
#include <cstdlib>
#include <string>

namespace twintrace {
namespace {

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\0';
}

}  // namespace

NffTokens::NffTokens(std::string_view text) : text_(text) {
  advance();
}

void NffTokens::skipLine() {
  while (at_ < text_.size() && text_[at_] != '\n') ++at_;
}

void NffTokens::skipSpaces() {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '#') skipLine();
    if (at_ == text_.size()) return;
    if (text_[at_] == '\n') {
      ++line_;
      lineBegin_ = at_ + 1;
      beginsLine_ = true;
    } else if (!isSpace(text_[at_])) {
      return;
    }
  }
}

void NffTokens::advance() {
  skipSpaces();
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '#' && !isSpace(text_[at_])) {
    ++at_;
  }
  current_ = {text_.substr(begin, at_ - begin), line_, static_cast<int>(begin - lineBegin_) + 1,
              beginsLine_};
  beginsLine_ = false;
}

std::optional<double> parseNffNumber(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  // from_chars leaves the value alone where it is out of range.
  if (error == std::errc::result_out_of_range)
    return std::strtod(std::string(word).c_str(), nullptr);
  return value;
}

}  // namespace twintrace
