#include "common/base/wording.h"

#include <string>
#include <vector>

#include "tests/catch.h"

namespace twintrace {
namespace {

TEST_CASE("quote makes control characters visible", "[base]") {
  CHECK(quote("") == "''");
  CHECK(quote(std::string_view("a\0b\n\x7f", 5)) == "'a\\x00b\\x0a\\x7f'");
}

TEST_CASE("quote cuts long text at a whole character", "[base]") {
  CHECK(quote(std::string(60, 'a')) == "'" + std::string(60, 'a') + "'");
  CHECK(quote(std::string(61, 'a')) == "'" + std::string(60, 'a') + "...'");
  CHECK(quote(std::string(59, 'a') + "\xc3\xa9") == "'" + std::string(59, 'a') + "...'");
}

TEST_CASE("oneOf joins words and counts those beyond thirty", "[base]") {
  CHECK(oneOf(std::vector<std::string>{}) == "");
  CHECK(oneOf(std::vector<std::string>{"a"}) == "a");
  CHECK(oneOf(std::vector<std::string>{"a", "b"}) == "a or b");
  CHECK(oneOf(std::vector<std::string>{"a", "b", "c"}) == "a, b or c");
  CHECK(oneOf(std::vector<std::string>(32, "a")).ends_with("a, a or 2 others"));
}

}  // namespace
}  // namespace twintrace
