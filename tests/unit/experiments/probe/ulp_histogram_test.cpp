#include "experiments/probe/ulp_histogram.h"

#include "tests/catch.h"

using twintrace::probe::UlpHistogram;

TEST_CASE("UlpHistogram counts distances by powers of two", "[probe]") {
  UlpHistogram histogram;
  for (const std::uint32_t ulps : {0u, 0u, 1u, 2u, 3u, 4u, 7u, 8u, 0xfffffffeu}) histogram.add(ulps);
  CHECK(histogram.count(0) == 2);
  CHECK(histogram.count(1) == 1);
  CHECK(histogram.count(2) == 2);
  CHECK(histogram.count(3) == 2);
  CHECK(histogram.count(4) == 1);
  CHECK(histogram.count(32) == 1);
  CHECK(histogram.count(33) == 0);
  CHECK(histogram.total() == 9);
  CHECK(histogram.largest() == 0xfffffffeu);
}

TEST_CASE("UlpHistogram keeps apart what has no distance", "[probe]") {
  UlpHistogram histogram;
  histogram.add(0xffffffffu);
  CHECK(histogram.count(UlpHistogram::kBinCount - 1) == 1);
  CHECK(histogram.total() == 1);
}

TEST_CASE("UlpHistogram names its bins", "[probe]") {
  CHECK(UlpHistogram::label(0) == "0");
  CHECK(UlpHistogram::label(1) == "1");
  CHECK(UlpHistogram::label(2) == "2-3");
  CHECK(UlpHistogram::label(32) == "2147483648-4294967295");
  CHECK(UlpHistogram::label(33) == "other");
}

TEST_CASE("UlpHistogram tells within which bin a share lies", "[probe]") {
  UlpHistogram histogram;
  for (int i = 0; i < 97; ++i) histogram.add(0u);
  histogram.add(1u);
  histogram.add(3u);
  histogram.add(0xffffffffu);
  CHECK(histogram.within(0.97) == "0");
  CHECK(histogram.within(0.98) == "1");
  CHECK(histogram.within(0.99) == "2-3");
  CHECK(histogram.within(1.0) == "other");
}
