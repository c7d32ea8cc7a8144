#include "common/stats/welch.h"

#include <cmath>
#include <limits>
#include <vector>

#include "common/stats/distributions.h"
#include "tests/catch.h"

using namespace twintrace;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("meanEstimate of equal values has no error", "[stats]") {
  const MeanEstimate estimate = meanEstimate(std::vector<double>(33, 0.1));
  CHECK(estimate.mean == 0.1);
  CHECK(estimate.standardError == 0.0);
}

TEST_CASE("welchTwoSided decides exactly without errors", "[stats]") {
  CHECK(welchTwoSided({0.1, 0.0, 31}, {0.1, 0.0, 31}) == 1.0);
  CHECK(welchTwoSided({0.1, 0.0, 31}, {std::nextafter(0.1, 1.0), 0.0, 31}) == 0.0);
}

TEST_CASE("welchTwoSided knows nothing where an error is not known", "[stats]") {
  CHECK(welchTwoSided({0.0, kInfinity, kInfinity}, {9.0, 0.1, 31}) == 1.0);
}

// Errors of the means 1/2 and 5/3, so t = -2 / sqrt(13/6) and, after Satterthwaite,
// dof = (13/6)^2 / (1/16 + 25/27).
TEST_CASE("welchTwoSided is Welch's t with Satterthwaite's degrees of freedom", "[stats]") {
  const MeanEstimate a = meanEstimate(std::vector<double>{1, 2, 3, 4, 5});
  const MeanEstimate b = meanEstimate(std::vector<double>{2, 4, 6, 8});
  CHECK(a.mean == 3.0);
  CHECK(a.standardError == Approx(std::sqrt(0.5)));
  CHECK(b.standardError == Approx(std::sqrt(5.0 / 3.0)));
  const double dof = 169.0 / 36.0 / (1.0 / 16.0 + 25.0 / 27.0);
  CHECK(welchDof(0.5, 4, 5.0 / 3.0, 3) == Approx(dof));
  CHECK(welchTwoSided(a, b) == Approx(studentTwoSided(2.0 / std::sqrt(13.0 / 6.0), dof)));
}

TEST_CASE("welchTwoSided rejects less where skewness explains the difference", "[stats]") {
  MeanEstimate a{-5.0, 1.0, 31};  // too low, as an arm that missed its rare bright values
  const MeanEstimate b{0.0, 0.0, 31};
  const double plain = welchTwoSided(a, b);
  a.thirdCumulant = 0.3;
  // Hall: -5 + 0.3 * 25 / 3 - 0.09 * 125 / 27 + 0.3 / 6
  CHECK(welchTwoSided(a, b) == Approx(studentTwoSided(-5.0 + 2.5 - 11.25 / 27.0 + 0.05, 31)));
  a.thirdCumulant = -0.3;
  CHECK(welchTwoSided(a, b) == plain);
  a.mean = -0.1;  // and the transformation would cross zero
  a.thirdCumulant = 1.0;
  CHECK(welchTwoSided(a, b) == 1.0);
}

TEST_CASE("meanEstimate finds the third cumulant of the mean", "[stats]") {
  // Deviations -1, -1, -1, 3: unbiased third moment 4 * 24 / (3 * 2) = 16, over 4^2.
  CHECK(meanEstimate(std::vector<double>{0, 0, 0, 4}).thirdCumulant == Approx(1.0));
  CHECK(meanEstimate(std::vector<double>{0, 4}).thirdCumulant == 0.0);
}

TEST_CASE("welchDof survives the underflow of tiny errors", "[stats]") {
  CHECK(welchDof(1e-200, 31, 1e-200, 40) == 31);
}
