#include "common/scene/toml_document.h"

#include <string>

#include "tests/catch.h"
#include "tests/unit/scene/faults.h"

namespace twintrace {
namespace {

TEST_CASE("parseToml words toml++'s expectations as found and expected", "[scene]") {
  CHECK(faultsOf("a = 1 2") ==
        "s.toml:1:7: found '2' in the key-value pair, expected a comment or whitespace");
  CHECK(faultsOf("\n = 3") ==
        "s.toml:2:2: found '=' in the root table, expected keys, tables, whitespace or comments");
}

TEST_CASE("parseToml reports a table's header that starts no key, in debug builds too", "[scene]") {
  CHECK(faultsOf("[=]") ==
        "s.toml:1:2: found '=' in the key, expected bare key starting character or string "
        "delimiter");
}

TEST_CASE("parseToml reports a character that toml++ holds for unreachable", "[scene]") {
  CHECK(faultsOf("a \xef\xb7\xba = 1") ==
        "s.toml:1:3: found '\xef\xb7\xba' in the key-value pair, expected '='");
}

TEST_CASE("parseToml reports the end of the file inside a value", "[scene]") {
  CHECK(faultsOf("a = [1,") ==
        "s.toml:1:8: found the end of the file, expected the rest of the array");
}

TEST_CASE("parseToml reports keys and tables given twice", "[scene]") {
  CHECK(faultsOf("[film]\nwidth = 1\nwidth = 2") ==
        "s.toml:3:9: found 'width' a second time, expected each key and table once");
  CHECK(faultsOf("[materials.white]\n[materials.white]") ==
        "s.toml:2:1: found 'materials.white' a second time, expected each key and table once");
}

TEST_CASE("parseToml reports numbers that do not fit in 64 bits", "[scene]") {
  CHECK(faultsOf("a = 99999999999999999999") ==
        "s.toml:1:25: found '99999999999999999999', expected a number that fits in 64 bits");
  CHECK(faultsOf("a = 1e400") ==
        "s.toml:1:10: found '1e400', expected a number that fits in 64 bits");
}

TEST_CASE("parseToml reports what is no TOML otherwise", "[scene]") {
  CHECK(faultsOf("a = \"\\q\"") ==
        "s.toml:1:7: found a fault in the string (unknown escape sequence '\\q'), expected TOML "
        "1.0");
  CHECK(faultsOf("\xff") ==
        "s.toml:1:1: found a fault in the text (Encountered invalid utf-8 sequence), expected TOML "
        "1.0");
}

TEST_CASE("parseToml takes line ends of both kinds and a byte order mark", "[scene]") {
  CHECK(faultsOf("\xef\xbb\xbf# comment\r\n[film]\r\nwidth = 8\r\n") == "");
}

TEST_CASE("parseToml refuses keys too deep to be freed", "[scene]") {
  std::string key = "a";
  for (int i = 0; i < 100000; ++i) key += ".a";
  CHECK(faultsOf("[film]\n" + key + " = 1") ==
        "s.toml:2:1: found 100000 dots in one line, expected at most 4096");
}

TEST_CASE("parseToml reads keys as deep as it allows", "[scene]") {
  std::string key = "a";
  for (int i = 0; i < 4096; ++i) key += ".a";
  CHECK(faultsOf("[" + key + "]\n" + key + " = 1").starts_with("s.toml:1:2: found table 'a'"));
}

}  // namespace
}  // namespace twintrace
