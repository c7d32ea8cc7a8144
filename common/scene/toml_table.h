#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene/toml_document.h"

namespace twintrace {

/// Which numbers a key takes, beyond being finite and at most kMaxMagnitude in size.
struct NumberRule {
  std::string_view expected;
  bool (*holds)(float value);
};

/// Numbers in a scene stay below this, so that squared lengths (at most 3 * (2e18)^2 = 1.2e37) do
/// not overflow a float (3.4e38).
inline constexpr double kMaxMagnitude = 1e18;
/// Lengths that must not be zero stay above this, so that their squares are no float denormals,
/// which the tracers flush to zero.
inline constexpr float kMinLength = 1e-18f;

inline constexpr NumberRule kAnyNumber{"a number", [](float) { return true; }};
inline constexpr NumberRule kNotNegative{"a number >= 0", [](float v) { return v >= 0; }};
inline constexpr NumberRule kPositiveLength{"a number above 0 (at least 1e-18)",
                                            [](float v) { return v >= kMinLength; }};
inline constexpr NumberRule kUnitInterval{"a number from 0 to 1",
                                          [](float v) { return v >= 0 && v <= 1; }};
inline constexpr NumberRule kFieldOfView{"an angle above 0 and below 180 degrees",
                                         [](float v) { return v > 0 && v < 180; }};
inline constexpr NumberRule kHalfTurn{"an angle from 0 to 180 degrees",
                                      [](float v) { return v >= 0 && v <= 180; }};

enum class Need { optional, required };

/// A TOML value in words for a message, for example `'text'`, `3`, `an array of 2 values`.
std::string describe(const toml::node& node);

/// Length of a vector of numbers up to kMaxMagnitude, in double.
double lengthOf(const glm::vec3& vector);

/// Reads one table by its known keys. Each read notes the key as known and any fault at its place;
/// `finish` then reports the keys that no read asked for.
class TableReader {
 public:
  /// @param at where to report keys that are missing.
  TableReader(const toml::table& table, toml::source_position at, Faults& faults)
      : table_(table), at_(at), faults_(faults) {}

  /// The value of a key, or nullptr; a required one that is missing is a fault.
  const toml::node* find(std::string_view key, std::string_view expected, Need need);

  bool has(std::string_view key) const { return table_.contains(key); }
  /// Where the value of a key stands, or the table if there is none.
  toml::source_position positionOf(std::string_view key) const;
  /// Where the key itself stands, or the table if there is none.
  toml::source_position keyPositionOf(std::string_view key) const;

  /// These set `into` and return true if the key is there and its value is right.
  bool read(std::string_view key, float& into, const NumberRule& rule, Need need = Need::optional);
  bool read(std::string_view key, glm::vec3& into, const NumberRule& rule,
            Need need = Need::optional);
  bool read(std::string_view key, bool& into);
  /// A whole number in [low, high].
  bool read(std::string_view key, std::int64_t& into, std::int64_t low, std::int64_t high,
            Need need = Need::optional);
  /// Text without control characters.
  bool read(std::string_view key, std::string& into, std::string_view expected,
            Need need = Need::optional);
  /// One of some words.
  bool readWord(std::string_view key, std::string& into, const std::vector<std::string>& words,
                Need need = Need::optional);
  /// A vector whose length is at least kMinLength.
  bool readDirection(std::string_view key, glm::vec3& into, Need need = Need::optional);

  /// The table of a key, or nullptr.
  const toml::table* readTable(std::string_view key);
  /// The array of tables of a key; elements that are no tables are faults and left out.
  std::vector<const toml::table*> readTables(std::string_view key);

  /// Reports all keys that were never asked for, with the nearest known one.
  void finish();

  Faults& faults() { return faults_; }
  toml::source_position position() const { return at_; }
  const toml::table& table() const { return table_; }

 private:
  bool readNumber(const toml::node& node, float& into, const NumberRule& rule);

  const toml::table& table_;
  toml::source_position at_;
  Faults& faults_;
  std::vector<std::string> known_;
};

}  // namespace twintrace
