#include "common/cast/csv_rows.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "common/base/wording.h"

namespace twintrace {
namespace {

constexpr std::string_view kSpaces = " \t\r";
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The field between two offsets of a line, without the spaces around it.
CsvField fieldOf(std::string_view line, std::size_t begin, std::size_t end) {
  const std::string_view text = line.substr(begin, end - begin);
  const std::size_t first = text.find_first_not_of(kSpaces);
  if (first == std::string_view::npos) return {{}, static_cast<int>(begin) + 1};
  const std::size_t last = text.find_last_not_of(kSpaces);
  return {text.substr(first, last - first + 1), static_cast<int>(begin + first) + 1};
}

void split(std::string_view line, std::vector<CsvField>& fields) {
  fields.clear();
  std::size_t begin = 0;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos;
       comma = line.find(',', begin)) {
    fields.push_back(fieldOf(line, begin, comma));
    begin = comma + 1;
  }
  fields.push_back(fieldOf(line, begin, line.size()));
}

/// strtof also takes what is no number of a table, such as nan(0x1) and leading space.
bool looksLikeNumber(std::string_view text) {
  return !text.empty() && std::isspace(static_cast<unsigned char>(text.front())) == 0 &&
         text.find('(') == std::string_view::npos && text.find('\0') == std::string_view::npos;
}

}  // namespace

void forEachCsvRow(std::string_view text, const std::function<void(const CsvRow&)>& visit) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  CsvRow row;
  for (row.line = 1; !text.empty(); ++row.line) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const std::string_view content = line.substr(0, line.find('#'));
    if (content.find_first_not_of(kSpaces) == std::string_view::npos) continue;
    split(content, row.fields);
    visit(row);
  }
}

std::optional<float> parseFloat(std::string_view text) {
  if (!looksLikeNumber(text)) return std::nullopt;
  const std::string word(text);
  char* end = nullptr;
  const float value = std::strtof(word.c_str(), &end);
  if (end != word.c_str() + word.size()) return std::nullopt;
  return value;
}

std::string readCsvText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file.is_open() && file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad()) throw IoError("can't read " + path);
  return std::move(text).str();
}

void CsvFaults::add(int line, int column, std::string_view found, std::string_view expected) {
  diagnostics_.push_back(
      {{path_, line, column}, fmt::format("found {}, expected {}", found, expected)});
}

float CsvFaults::number(int line, const CsvField& field) {
  const std::optional<float> value = parseFloat(field.text);
  if (!value) add(line, field.column, quote(field.text), "a number");
  return value.value_or(0.0f);
}

void CsvFaults::throwIfAny() const {
  if (!diagnostics_.empty()) throw FileError(diagnostics_);
}

std::string hexFloat(double value) {
  return fmt::format("{:a}", value);
}

std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

}  // namespace twintrace
