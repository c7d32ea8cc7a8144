#include "common/stats/distributions.h"

#include <limits>

#include "tests/catch.h"

using namespace twintrace;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("tails of infinite and missing statistics are exact", "[stats]") {
  CHECK(normalTwoSided(kInfinity) == 0.0);
  CHECK(normalTwoSided(-kInfinity) == 0.0);
  CHECK(normalTwoSided(kNan) == 1.0);
  CHECK(studentTwoSided(-kInfinity, 5) == 0.0);
  CHECK(studentTwoSided(kNan, 5) == 1.0);
  CHECK(studentUpper(-kInfinity, 5) == 1.0);
  CHECK(studentUpper(kNan, 5) == 1.0);
  CHECK(chiSquareUpper(kInfinity, 3) == 0.0);
  CHECK(chiSquareUpper(0.0, 3) == 1.0);
  CHECK(binomialUpper(0, 10, 0.5) == 1.0);
}

// Closed forms: one degree of freedom is the Cauchy distribution, chi-square of 2 exponential.
TEST_CASE("tails agree with closed forms", "[stats]") {
  CHECK(studentTwoSided(1.0, 1) == Approx(0.5));
  CHECK(studentTwoSided(-1.0, 1) == Approx(0.5));
  CHECK(studentUpper(0.0, 7) == Approx(0.5));
  CHECK(chiSquareUpper(3.0, 2) == Approx(std::exp(-1.5)));
  CHECK(binomialUpper(9, 10, 0.5) == Approx(11.0 / 1024.0));
  CHECK(normalTwoSided(1.959963984540054) == Approx(0.05));
  CHECK(studentTwoSided(1.959963984540054, kInfinity) == Approx(0.05));
}

TEST_CASE("far tails keep their digits", "[stats]") {
  CHECK(normalTwoSided(10.0) == Approx(1.5239706048321e-23));
  CHECK(normalTwoSided(30.0) > 0.0);
}
