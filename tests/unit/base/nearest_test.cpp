#include "common/base/nearest.h"

#include <string>
#include <vector>

#include "tests/catch.h"

namespace twintrace {
namespace {

TEST_CASE("editDistance counts each kind of edit as one", "[base]") {
  CHECK(editDistance("", "") == 0);
  CHECK(editDistance("", "abc") == 3);
  CHECK(editDistance("abc", "") == 3);
  CHECK(editDistance("radius", "radius") == 0);
  CHECK(editDistance("radus", "radius") == 1);
  CHECK(editDistance("radiuss", "radius") == 1);
  CHECK(editDistance("radiis", "radius") == 1);
  CHECK(editDistance("raduis", "radius") == 1);
  CHECK(editDistance("ca", "abc") == 3);
}

TEST_CASE("nearest finds the candidate of the fewest edits, the first of equals", "[base]") {
  const std::vector<std::string> keys = {"center", "radius", "ratios", "name"};
  CHECK(nearest("radus", keys) == "radius");
  CHECK(nearest("centre", keys) == "center");
  CHECK(nearest("ra_ius", std::vector<std::string>{"raaius", "rabius"}) == "raaius");
}

TEST_CASE("nearest finds nothing where a suggestion would be a guess", "[base]") {
  const std::vector<std::string> keys = {"center", "radius"};
  CHECK_FALSE(nearest("", keys));
  CHECK_FALSE(nearest("colour", keys));
  CHECK_FALSE(nearest("radius", {}));
  CHECK_FALSE(nearest(std::string(1000, 'r'), keys));
}

}  // namespace
}  // namespace twintrace
