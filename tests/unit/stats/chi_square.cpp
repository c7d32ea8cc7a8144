#include "common/stats/chi_square.h"

#include <random>
#include <vector>

#include "common/base/error.h"
#include "common/stats/distributions.h"
#include "tests/catch.h"

using namespace twintrace;

using Counts = std::vector<std::uint64_t>;
using Expected = std::vector<double>;

TEST_CASE("chiSquareTest is Pearson's statistic", "[stats]") {
  const ChiSquare result =
      chiSquareTest(Counts{30, 14, 34, 45, 57, 20}, Expected{20, 20, 30, 40, 60, 30});
  CHECK(result.statistic == Approx(5.0 + 1.8 + 16.0 / 30 + 0.625 + 0.15 + 100.0 / 30));
  CHECK(result.dof == 5);
  CHECK(result.p == Approx(chiSquareUpper(result.statistic, 5)));
}

TEST_CASE("chiSquareTest pools bins until each expects 5", "[stats]") {
  const ChiSquare result = chiSquareTest(Counts{1, 5, 10, 3, 1}, Expected{2, 4, 10, 2, 2});
  CHECK(result.dof == 1);  // {6, 6} and {10 + 4, 10 + 4}
  CHECK(result.statistic == 0.0);
  CHECK(chiSquareTest(Counts{1, 2}, Expected{2, 1}).p == 1.0);
}

TEST_CASE("chiSquareTest rejects a hit where none can be", "[stats]") {
  CHECK(chiSquareTest(Counts{10, 1, 9}, Expected{10, 0, 10}).p == 0.0);
  CHECK(chiSquareTest(Counts{10, 0, 10}, Expected{10, 0, 10}).p == 1.0);
}

TEST_CASE("chiSquareTest refuses what can't be compared", "[stats]") {
  CHECK_THROWS_AS(chiSquareTest(Counts{1, 2}, Expected{3}), UsageError);
  CHECK_THROWS_AS(chiSquareTest(Counts{10, 10}, Expected{10, 11}), UsageError);
  CHECK_THROWS_AS(chiSquareTest(Counts{10, 10}, Expected{21, -1}), UsageError);
}

TEST_CASE("chiSquareTest finds a distribution that is off by a little", "[stats]") {
  std::mt19937 random(3);
  Counts counts(16, 0);
  for (int i = 0; i < 100000; ++i) ++counts[random() % 17 % 16];  // bin 0 twice as likely
  CHECK(chiSquareTest(counts, Expected(16, 6250.0)).p < 1e-9);
}
