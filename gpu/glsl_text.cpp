#include "gpu/glsl_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "common/base/wording.h"
#include "common/base/word_char.h"

namespace twintrace {
namespace {

void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (text[i] != '\n' && text[i] != '\r') text[i] = ' ';
  }
}

std::size_t lineEnd(std::string_view text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

/// Blanks lines that begin with #, and those that a backslash joins to them.
void blankDirectives(std::string& text) {
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = lineEnd(text, begin);
    const std::size_t first = text.find_first_not_of(" \t\r", begin);
    if (first < end && text[first] == '#') {
      while (end > begin && end < text.size() && text[end - 1] == '\\')
        end = lineEnd(text, end + 1);
      blank(text, begin, end);
    }
    begin = end + 1;
  }
}

/// A word (identifier or number) or a single other character.
struct Token {
  std::string_view text;
  std::size_t at = 0;

  std::size_t end() const { return at + text.size(); }
  bool isWord() const { return isWordChar(text.front()); }
};

std::vector<Token> tokensOf(std::string_view text) {
  std::vector<Token> tokens;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    if (isWordChar(text[at])) {
      while (end < text.size() && isWordChar(text[end])) ++end;
    }
    if (std::isspace(static_cast<unsigned char>(text[at])) == 0) {
      tokens.push_back({text.substr(at, end - at), at});
    }
    at = end;
  }
  return tokens;
}

bool isQualifier(std::string_view word) {
  constexpr std::array<std::string_view, 11> kWords = {"precise", "highp", "mediump",  "lowp",
                                                       "const",   "flat",  "smooth",   "in",
                                                       "out",     "inout", "invariant"};
  return std::ranges::find(kWords, word) != kWords.end();
}

using Tokens = std::span<const Token>;

/// `[4]` and `[kCount]` as written, without blanks; moves `at` behind them.
std::string takeArray(Tokens tokens, std::size_t& at) {
  std::string array;
  while (at < tokens.size() && tokens[at].text == "[") {
    while (at < tokens.size() && tokens[at].text != "]") array += tokens[at++].text;
    if (at < tokens.size()) array += tokens[at++].text;
  }
  return array;
}

/// Splits at the separator where it lies in no bracket.
std::vector<Tokens> splitAt(Tokens tokens, std::string_view separator) {
  std::vector<Tokens> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string_view text = tokens[i].text;
    if (text == "(" || text == "[") ++depth;
    if (text == ")" || text == "]") --depth;
    if (depth == 0 && text == separator) {
      parts.push_back(tokens.subspan(begin, i - begin));
      begin = i + 1;
    }
  }
  if (begin < tokens.size()) parts.push_back(tokens.subspan(begin));
  return parts;
}

/// Reads the definitions of a text whose comments and directives are blank.
class Parser {
 public:
  explicit Parser(GlslText& result) : result_(result), all_(tokensOf(result.text)) {}

  void parse() {
    while (at_ < all_.size()) statement();
  }

 private:
  [[noreturn]] void complain(std::size_t place, const std::string& found,
                             const std::string& expected) const {
    throw FileError({{result_.location(place), "found " + found + ", expected " + expected}});
  }

  /// The place behind the bracket that closes the one at `open`.
  std::size_t behindPartner(std::size_t open) const {
    const std::string_view opening = all_[open].text;
    const std::string_view closing = opening == "{" ? "}" : opening == "(" ? ")" : "]";
    int depth = 0;
    for (std::size_t i = open; i < all_.size(); ++i) {
      if (all_[i].text == opening) ++depth;
      if (all_[i].text == closing && --depth == 0) return i + 1;
    }
    complain(all_[open].at, quote(opening) + " without its partner",
             quote(closing) + " before the end of the file");
  }

  /// A definition or declaration of the outermost level, up to its semicolon or closing brace.
  void statement() {
    const std::size_t begin = at_;
    bool assigned = false;
    while (at_ < all_.size()) {
      const std::string_view text = all_[at_].text;
      if (text == ";") {
        ++at_;
        return;
      }
      if (text == "}" || text == ")") {
        complain(all_[at_].at, quote(text) + " without its partner", "a definition");
      }
      if (text == "=") assigned = true;
      if (text == "{" && !assigned) return block(begin);
      at_ = text == "(" || text == "{" ? behindPartner(at_) : at_ + 1;
    }
    complain(all_[begin].at, "a definition without its end",
             "';' or '{' before the end of the file");
  }

  /// At the brace that follows the head of a function, a structure or an interface block.
  void block(std::size_t begin) {
    const std::size_t open = at_;
    at_ = behindPartner(open);
    if (open > begin && all_[open - 1].text == ")") {
      function(begin, open);
      return;
    }
    const std::size_t behind = at_;
    while (at_ < all_.size() && all_[at_].text != ";") ++at_;
    if (at_ == all_.size()) {
      complain(all_[behind - 1].at, "'}' at the end of a structure or block", "';' behind it");
    }
    ++at_;
    const std::size_t keyword = skipQualifiers(begin);
    if (all_[keyword].text == "struct" && keyword + 2 == open)
      structure(begin, keyword + 1, behind);
  }

  std::size_t skipQualifiers(std::size_t at) const {
    while (isQualifier(all_[at].text)) ++at;
    return at;
  }

  Tokens tokens(std::size_t begin, std::size_t end) const {
    return Tokens(all_).subspan(begin, end - begin);
  }

  void function(std::size_t begin, std::size_t open) {
    const std::size_t first = skipQualifiers(begin);
    std::size_t at = first + 1;
    GlslFunction function;
    function.result = std::string(all_[first].text) + takeArray(all_, at);
    if (!all_[first].isWord() || at + 1 >= open || !all_[at].isWord() || all_[at + 1].text != "(" ||
        behindPartner(at + 1) != open) {
      complain(all_[begin].at, quote(all_[begin].text) + " before a block",
               "a function as in 'float name(float x) {'");
    }
    function.name = all_[at].text;
    function.place = all_[at].at;
    function.body = {all_[open].at, all_[at_ - 1].end()};
    function.whole = {all_[begin].at, all_[at_ - 1].end()};
    for (const Tokens& part : splitAt(tokens(at + 2, open - 1), ",")) {
      if (part.size() == 1 && part[0].text == "void") continue;
      function.parameters.push_back(parameter(part));
    }
    result_.functions.push_back(std::move(function));
  }

  GlslVariable parameter(Tokens part) const {
    GlslVariable found;
    std::size_t at = 0;
    for (; at < part.size() && isQualifier(part[at].text); ++at) {
      if (part[at].text == "out") found.direction = GlslDirection::out;
      if (part[at].text == "inout") found.direction = GlslDirection::inout;
    }
    if (at == part.size() || !part[at].isWord()) {
      const std::size_t place = part.empty() ? 0 : part.front().at;
      complain(place, "a parameter without its type", "a parameter as in 'float x'");
    }
    found.place = part[at].at;
    found.type = part[at++].text;
    found.type += takeArray(part, at);
    if (at < part.size() && part[at].isWord()) found.name = part[at++].text;
    found.type += takeArray(part, at);
    if (at != part.size()) {
      complain(part[at].at, quote(part[at].text) + " in a parameter", "',' or ')'");
    }
    return found;
  }

  void structure(std::size_t begin, std::size_t name, std::size_t behind) {
    GlslStruct structure;
    structure.name = all_[name].text;
    structure.place = all_[name].at;
    structure.whole = {all_[begin].at, all_[at_ - 1].end()};
    for (const Tokens& declaration : splitAt(tokens(name + 2, behind - 1), ";")) {
      fields(declaration, structure.fields);
    }
    result_.structs.push_back(std::move(structure));
  }

  /// `float x, y[2];` is two fields.
  void fields(Tokens declaration, std::vector<GlslVariable>& found) const {
    std::size_t at = 0;
    while (at < declaration.size() && isQualifier(declaration[at].text)) ++at;
    if (at == declaration.size()) return;
    const Token type = declaration[at++];
    const std::string array = takeArray(declaration, at);
    for (const Tokens& part : splitAt(declaration.subspan(at), ",")) {
      std::size_t next = 1;
      if (part.empty() || !part[0].isWord()) {
        complain(type.at, "a field without its name", "a field as in 'float x;'");
      }
      found.push_back({std::string(type.text) + array + takeArray(part, next),
                       std::string(part[0].text), GlslDirection::in, type.at});
    }
  }

  GlslText& result_;
  std::vector<Token> all_;
  std::size_t at_ = 0;
};

}  // namespace

std::string GlslFunction::signature() const {
  std::string types;
  for (const GlslVariable& parameter : parameters) {
    types += (types.empty() ? "" : ", ") + parameter.type;
  }
  return name + "(" + types + ")";
}

const GlslStruct* GlslText::findStruct(std::string_view name) const {
  const auto found = std::ranges::find(structs, name, &GlslStruct::name);
  return found != structs.end() ? &*found : nullptr;
}

SourceLocation GlslText::location(std::size_t offset) const {
  const std::string_view before = std::string_view(text).substr(0, offset);
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 = 0
  return {path, static_cast<int>(line), static_cast<int>(offset - start) + 1};
}

std::string withoutGlslComments(std::string_view text) {
  std::string result(text);
  for (std::size_t at = 0; (at = text.find('/', at)) != std::string_view::npos;) {
    std::size_t end = at + 1;
    if (text.substr(at, 2) == "//") {
      end = lineEnd(text, at);
      while (end < text.size() && text[end - 1] == '\\') end = lineEnd(text, end + 1);
      blank(result, at, end);
    } else if (text.substr(at, 2) == "/*") {
      const std::size_t close = text.find("*/", at + 2);
      end = close == std::string_view::npos ? text.size() : close + 2;
      blank(result, at, end);
    }
    at = end;
  }
  return result;
}

GlslText parseGlsl(std::string_view text, const std::string& path) {
  GlslText result;
  result.path = path;
  result.text = withoutGlslComments(text);
  blankDirectives(result.text);
  Parser(result).parse();
  return result;
}

}  // namespace twintrace
