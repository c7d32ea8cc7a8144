#include "common/stats/multiple_testing.h"

#include "tests/catch.h"

using namespace twintrace;

TEST_CASE("holmAdjusted steps down and keeps the order given", "[stats]") {
  const std::vector<double> adjusted = holmAdjusted(std::vector<double>{0.04, 0.01, 0.03, 0.005});
  CHECK(adjusted[3] == Approx(0.02));
  CHECK(adjusted[1] == Approx(0.03));
  CHECK(adjusted[2] == Approx(0.06));
  CHECK(adjusted[0] == Approx(0.06));  // 1 * 0.04, raised to its predecessor
}

TEST_CASE("holmAdjusted stays within 0 and 1", "[stats]") {
  CHECK(holmAdjusted(std::vector<double>{}).empty());
  CHECK(holmAdjusted(std::vector<double>{0.9, 0.8, 0.0}) == std::vector<double>{1.0, 1.0, 0.0});
}

TEST_CASE("benjaminiHochbergCut is the largest p below its line", "[stats]") {
  CHECK(benjaminiHochbergCut({0.5, 0.01, 0.035, 0.02}, 0.05) == 0.035);  // 0.035 <= 3/4 * 0.05
  CHECK(benjaminiHochbergCut({0.5, 0.02, 0.04, 0.03}, 0.05) < 0.0);
  CHECK(benjaminiHochbergCut({}, 0.05) < 0.0);
  CHECK(benjaminiHochbergCut({0.0, 1.0}, 0.05) == 0.0);
}
