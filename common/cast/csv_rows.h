#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"

namespace twintrace {

/// One value of a row, without spaces around it. Columns count bytes from 1.
struct CsvField {
  std::string_view text;
  int column = 1;
};

/// A line with something on it.
struct CsvRow {
  int line = 1;
  std::vector<CsvField> fields;  ///< at least one
};

/// Calls the visitor with each row. Lines end with LF or CRLF, `#` begins a comment, empty lines
/// and a byte order mark at the start are left out. There is no quoting.
void forEachCsvRow(std::string_view text, const std::function<void(const CsvRow&)>& visit);

/// The number rounded to float32, ties to even: decimal or a C99 hex float, inf or nan, with a sign
/// or without. Beyond the largest float it is infinite. Nothing if the text is no number.
std::optional<float> parseFloat(std::string_view text);

/// All of a file. @throws IoError if it can't be read
std::string readCsvText(const std::string& path);

/// The faults of a file, reported together.
class CsvFaults {
 public:
  explicit CsvFaults(std::string path) : path_(std::move(path)) {}

  void add(int line, int column, std::string_view found, std::string_view expected);

  /// The field's number, or 0 and a fault.
  float number(int line, const CsvField& field);

  /// @throws FileError with all faults in the order of their lines, if there are any
  void throwIfAny() const;

 private:
  std::string path_;
  std::vector<Diagnostic> diagnostics_;
};

/// A hex float that reads back as the same number; `inf` and `nan` as such.
std::string hexFloat(double value);

/// Text as one field of a hits file: in quotes where it needs them (RFC 4180).
std::string csvField(std::string_view text);

}  // namespace twintrace
