#include "common/scene/toml_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/wording.h"

namespace twintrace {

namespace {

/// Shortest text that reads back as the number, recognisable as floating point.
std::string describeFloat(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

std::string describeCount(std::size_t count) {
  return fmt::format("an array of {} value{}", count, count == 1 ? "" : "s");
}

/// The float that the tracers see: they flush denormals to zero.
float toTracerFloat(double value) {
  const auto rounded = static_cast<float>(value);
  return std::abs(rounded) < std::numeric_limits<float>::min() ? 0.0f : rounded;
}

bool hasControlCharacter(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char byte) {
    const auto code = static_cast<unsigned char>(byte);
    return code < 0x20 || code == 0x7f;
  });
}

std::string describeVector(const glm::vec3& v) {
  return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

}  // namespace

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return quote(text->get());
  if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = node.as_floating_point()) return describeFloat(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* array = node.as_array()) return describeCount(array->size());
  if (node.is_table()) return "a table";
  return "a date or time";
}

double lengthOf(const glm::vec3& v) {
  return std::hypot(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
}

const toml::node* TableReader::find(std::string_view key, std::string_view expected, Need need) {
  known_.emplace_back(key);
  const toml::node* node = table_.get(key);
  if (node == nullptr && need == Need::required) {
    faults_.add(at_, "no key " + quote(key), std::string(expected));
  }
  return node;
}

toml::source_position TableReader::positionOf(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node != nullptr ? node->source().begin : at_;
}

toml::source_position TableReader::keyPositionOf(std::string_view key) const {
  const auto found = table_.find(key);
  return found != table_.end() ? found->first.source().begin : at_;
}

bool TableReader::readNumber(const toml::node& node, float& into, const NumberRule& rule) {
  const toml::source_position at = node.source().begin;
  if (!node.is_number()) {
    faults_.add(at, describe(node), std::string(rule.expected));
    return false;
  }
  const double value = node.value<double>().value_or(0.0);
  if (!std::isfinite(value)) {
    faults_.add(at, describe(node), "a finite number");
    return false;
  }
  if (std::abs(value) > kMaxMagnitude) {
    faults_.add(at, describe(node),
                "a number of at most 1e18 in size, whose square fits in a float");
    return false;
  }
  if (!rule.holds(toTracerFloat(value))) {
    faults_.add(at, describe(node), std::string(rule.expected));
    return false;
  }
  into = toTracerFloat(value);
  return true;
}

bool TableReader::read(std::string_view key, float& into, const NumberRule& rule, Need need) {
  const toml::node* node = find(key, rule.expected, need);
  return node != nullptr && readNumber(*node, into, rule);
}

bool TableReader::read(std::string_view key, glm::vec3& into, const NumberRule& rule, Need need) {
  const toml::node* node = find(key, "an array of 3 numbers", need);
  if (node == nullptr) return false;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->size() != 3) {
    faults_.add(node->source().begin, describe(*node), "an array of 3 numbers");
    return false;
  }
  glm::vec3 vector{0.0f};
  bool right = true;
  for (int i = 0; i < 3; ++i) {
    right = readNumber((*array)[static_cast<std::size_t>(i)], vector[i], rule) && right;
  }
  if (right) into = vector;
  return right;
}

bool TableReader::read(std::string_view key, bool& into) {
  const toml::node* node = find(key, "true or false", Need::optional);
  if (node == nullptr) return false;
  if (!node->is_boolean()) {
    faults_.add(node->source().begin, describe(*node), "true or false");
    return false;
  }
  into = node->as_boolean()->get();
  return true;
}

bool TableReader::read(std::string_view key, std::int64_t& into, std::int64_t low,
                       std::int64_t high, Need need) {
  const std::string expected = fmt::format("an integer from {} to {}", low, high);
  const toml::node* node = find(key, expected, need);
  if (node == nullptr) return false;
  const toml::value<std::int64_t>* number = node->as_integer();
  if (number == nullptr || number->get() < low || number->get() > high) {
    faults_.add(node->source().begin, describe(*node), expected);
    return false;
  }
  into = number->get();
  return true;
}

bool TableReader::read(std::string_view key, std::string& into, std::string_view expected,
                       Need need) {
  const toml::node* node = find(key, expected, need);
  if (node == nullptr) return false;
  if (!node->is_string() || hasControlCharacter(node->as_string()->get())) {
    faults_.add(node->source().begin, describe(*node), std::string(expected));
    return false;
  }
  into = node->as_string()->get();
  return true;
}

bool TableReader::readWord(std::string_view key, std::string& into,
                           const std::vector<std::string>& words, Need need) {
  const std::string expected = oneOf(words);
  std::string word;
  if (!read(key, word, expected, need)) return false;
  if (std::find(words.begin(), words.end(), word) == words.end()) {
    faults_.add(positionOf(key), quote(word), expected + didYouMean(word, words));
    return false;
  }
  into = word;
  return true;
}

bool TableReader::readDirection(std::string_view key, glm::vec3& into, Need need) {
  glm::vec3 direction{0.0f};
  if (!read(key, direction, kAnyNumber, need)) return false;
  if (lengthOf(direction) < kMinLength) {
    faults_.add(positionOf(key), describeVector(direction),
                "a vector that is not zero (of length at least 1e-18)");
    return false;
  }
  into = direction;
  return true;
}

const toml::table* TableReader::readTable(std::string_view key) {
  const toml::node* node = find(key, "a table", Need::optional);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) faults_.add(node->source().begin, describe(*node), "a table");
  return node->as_table();
}

std::vector<const toml::table*> TableReader::readTables(std::string_view key) {
  const std::string expected = fmt::format("tables, each headed [[{}]]", key);
  const toml::node* node = find(key, expected, Need::optional);
  if (node == nullptr) return {};
  if (!node->is_array()) {
    faults_.add(node->source().begin, describe(*node), expected);
    return {};
  }
  std::vector<const toml::table*> tables;
  for (const toml::node& element : *node->as_array()) {
    if (element.is_table()) {
      tables.push_back(element.as_table());
    } else {
      faults_.add(element.source().begin, describe(element), "a table");
    }
  }
  return tables;
}

void TableReader::finish() {
  for (const auto& [key, node] : table_) {
    const std::string_view name = key.str();
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const std::string what = node.is_table() || node.is_array_of_tables() ? "table " : "key ";
    faults_.add(key.source().begin, what + quote(name),
                (known_.size() > 1 ? "one of " : "") + oneOf(known_) + didYouMean(name, known_));
  }
}

}  // namespace twintrace
