#include "common/scene/option_names.h"

#include <string>

#include "common/base/error.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

TEST_CASE("setOption reads back what every option prints", "[options]") {
  RenderOptions changed;
  setOptions(changed,
             "backend=gpu,width=3,height=5,spp=7,passes=2,bounces=9,seed=11,first-sample=4,"
             "time=0.1,target-error=0.3,integrator=whitted,noise=sine,maths=native,"
             "precision=double,lanes=scalar,intersector=report,hull=embree,geometry=literal,"
             "gl=egl,stage=compute,threads=6,effects=box,lens");
  RenderOptions copy;
  for (const auto& [name, value] : listOptions(changed)) {
    CHECK(findOption(name)->get(copy) != value);
    setOption(copy, name, value);
    CHECK(findOption(name)->get(copy) == value);
  }
  CHECK(listOptions(copy) == listOptions(changed));
  CHECK(copy.effects == "box,lens");
}

TEST_CASE("setOption takes every word that an option lists", "[options]") {
  for (const Option& option : renderOptionTable()) {
    for (const std::string& word : option.choices) {
      RenderOptions options;
      setOption(options, option.name, word);
      CHECK(option.get(options) == word);
    }
  }
}

TEST_CASE("setOption names the nearest option and value", "[options]") {
  RenderOptions options;
  CHECK_THROWS_AS(setOption(options, "bounce", "3"), UsageError);
  CHECK_THROWS_WITH(setOption(options, "bounce", "3"),
                    Catch::Contains("found option 'bounce', expected one of backend, width,") &&
                        Catch::Contains("(did you mean 'bounces'?)"));
  CHECK_THROWS_WITH(setOption(options, "stage", "fragmet"),
                    "stage: found 'fragmet', expected fragment or compute (did you mean "
                    "'fragment'?)");
}

TEST_CASE("setOption reports text that is no number or out of range", "[options]") {
  RenderOptions options;
  const std::string bounces = "expected an integer from 0 to 1024";
  CHECK_THROWS_WITH(setOption(options, "bounces", ""), "bounces: found '', " + bounces);
  CHECK_THROWS_WITH(setOption(options, "bounces", "3x"), "bounces: found '3x', " + bounces);
  CHECK_THROWS_WITH(setOption(options, "bounces", "-1"), "bounces: found '-1', " + bounces);
  CHECK_THROWS_WITH(setOption(options, "bounces", "99999999999999999999"),
                    "bounces: found '99999999999999999999', " + bounces);
  CHECK_THROWS_AS(setOption(options, "time", "nan"), UsageError);
  CHECK_THROWS_AS(setOption(options, "time", "inf"), UsageError);
  CHECK_THROWS_AS(setOption(options, "effects", ""), UsageError);
  CHECK(listOptions(options) == listOptions(RenderOptions{}));
}

TEST_CASE("setOption lets the integrator imply the intersector unless given", "[options]") {
  RenderOptions options;
  setOption(options, "integrator", "report");
  CHECK(options.intersector == Intersector::report);
  setOption(options, "integrator", "path");
  CHECK(options.intersector == Intersector::robust);
  setOption(options, "intersector", "report");
  setOption(options, "integrator", "path");
  CHECK(options.intersector == Intersector::report);
}

TEST_CASE("setOption remembers that lanes were asked for", "[options]") {
  RenderOptions options;
  CHECK_FALSE(options.lanesGiven);
  setOption(options, "lanes", "wide");
  CHECK(options.lanesGiven);
}

TEST_CASE("setOptions reports parts that are no assignment", "[options]") {
  RenderOptions options;
  CHECK_THROWS_WITH(setOptions(options, "gpu"), "found 'gpu', expected name=value,name=value");
  CHECK_THROWS_AS(setOptions(options, ","), UsageError);
  CHECK_THROWS_AS(setOptions(options, "spp=1,,noise=pcg"), UsageError);
  CHECK_THROWS_AS(setOptions(options, "=1"), UsageError);
  CHECK_NOTHROW(setOptions(options, ""));
}

TEST_CASE("checkOptions reports films and sample ranges that can't be rendered", "[options]") {
  RenderOptions options;
  CHECK_NOTHROW(checkOptions(options));
  setOptions(options, "width=268435456,height=2");
  CHECK_THROWS_WITH(checkOptions(options),
                    "found a film of 268435456 x 2 pixels, expected at most 268435456 pixels");
  setOptions(options, "width=1,passes=4,first-sample=6");
  CHECK_THROWS_WITH(checkOptions(options),
                    "found first-sample 6 with passes 4, expected a multiple of passes");
}

TEST_CASE("setOption keeps the index after the last frame below 2^31", "[options]") {
  RenderOptions options;
  setOptions(options, "passes=4096,spp=1073741824,first-sample=1073741824");
  CHECK_THROWS_AS(setOption(options, "spp", "1073741825"), UsageError);
  CHECK(std::int64_t{options.firstSample} + std::int64_t{options.frameCount()} * options.passes <=
        std::int64_t{1} << 31);
}

}  // namespace
}  // namespace twintrace
