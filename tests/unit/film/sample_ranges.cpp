#include "common/film/sample_ranges.h"

#include "common/base/error.h"
#include "tests/catch.h"
#include "tests/unit/film/film_fixtures.h"

using namespace twintrace;

namespace {

SampleRanges rangesOf(const std::vector<SampleRange>& list) {
  SampleRanges ranges;
  for (const SampleRange& range : list) ranges.add(range);
  return ranges;
}

}  // namespace

TEST_CASE("SampleRanges joins ranges that touch, in any order", "[film]") {
  CHECK(rangesOf({{8, 4}, {0, 4}, {4, 4}}).list() == std::vector<SampleRange>{{0, 12}});
  CHECK(rangesOf({{0, 4}, {8, 4}}).list() == std::vector<SampleRange>{{0, 4}, {8, 4}});
  CHECK(rangesOf({{4, 4}, {0, 4}}).list() == std::vector<SampleRange>{{0, 8}});
}

TEST_CASE("SampleRanges counts and names its samples", "[film]") {
  const SampleRanges ranges = rangesOf({{128, 64}, {0, 64}});
  CHECK(ranges.sampleCount() == 128);
  CHECK(ranges.toString() == "0-63,128-191");
  CHECK(SampleRanges().toString().empty());
}

TEST_CASE("SampleRanges refuses an overlap and names both ranges", "[film]") {
  SampleRanges ranges = rangesOf({{0, 4}, {8, 4}});
  for (const SampleRange& overlap : {SampleRange{3, 1}, {0, 4}, {7, 2}, {4, 9}, {11, 5}}) {
    CHECK_THROWS_AS(ranges.add(overlap), UsageError);
  }
  CHECK(ranges.list() == std::vector<SampleRange>{{0, 4}, {8, 4}});
  const std::string message = test::messageOf<UsageError>([&] { ranges.add(SampleRange{2, 4}); });
  CHECK(message == "samples 2-5 overlap samples 0-3 that the film already holds");
}

TEST_CASE("SampleRanges refuses empty ranges and indices beyond 2^32", "[film]") {
  SampleRanges ranges;
  CHECK_THROWS_AS(ranges.add(SampleRange{5, 0}), UsageError);
  CHECK_THROWS_AS(ranges.add(SampleRange{0xffffffffu, 2}), UsageError);
  CHECK_NOTHROW(ranges.add(SampleRange{0xffffffffu, 1}));
}

TEST_CASE("SampleRanges adds all ranges of another set or none", "[film]") {
  SampleRanges ranges = rangesOf({{20, 10}});
  CHECK_THROWS_AS(ranges.add(rangesOf({{0, 10}, {25, 10}})), UsageError);
  CHECK(ranges.list() == std::vector<SampleRange>{{20, 10}});
}
