#pragma once

#include <optional>
#include <string_view>

namespace twintrace {

/// A word of an NFF file, or its end. Lines and columns count from 1, columns in bytes.
struct NffToken {
  std::string_view text;  ///< empty at the end of the file
  int line = 1;
  int column = 1;
  bool beginsLine = false;

  bool isEnd() const { return text.empty(); }
};

/// The words of an NFF file one by one, without comments, which begin with `#`.
class NffTokens {
 public:
  /// @param text must outlive this
  explicit NffTokens(std::string_view text);

  const NffToken& current() const { return current_; }
  void advance();

 private:
  void skipSpaces();
  void skipLine();

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t lineBegin_ = 0;
  int line_ = 1;
  bool beginsLine_ = true;
  NffToken current_;
};

/// The number that a word stands for, decimal; beyond a double's range it is infinite or 0. Nothing
/// if the word is no number.
std::optional<double> parseNffNumber(std::string_view word);

}  // namespace twintrace
