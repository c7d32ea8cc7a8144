#include "common/stats/image_estimate.h"

#include <cmath>

#include "common/base/error.h"
#include "common/stats/z_map.h"
#include "tests/catch.h"

using namespace twintrace;

namespace {

ExrContent contentOf(float variance, float count) {
  ExrContent content;
  content.image = Image(2, 1);
  content.variance = Image(2, 1);
  content.variance.rgb.assign(6, variance);
  content.count.assign(2, count);
  return content;
}

ImageEstimate estimateOf(std::vector<float> values, float error) {
  Image mean(static_cast<int>(values.size() / 3), 1);
  Image errors = mean;
  mean.rgb = std::move(values);
  errors.rgb.assign(errors.rgb.size(), error);
  return estimateFrom(mean, errors);
}

}  // namespace

TEST_CASE("estimateFrom divides the variance by the frames", "[stats]") {
  CHECK(estimateFrom(contentOf(4.0f, 16.0f), "a").standardError.rgb[5] == 0.5f);
  CHECK(std::isinf(estimateFrom(contentOf(0.0f, 1.0f), "a").standardError.rgb[0]));
}

TEST_CASE("estimateFrom says what a file lacks", "[stats]") {
  ExrContent content = contentOf(1.0f, 4.0f);
  content.count.clear();
  CHECK_THROWS_WITH(estimateFrom(content, "a.exr"),
                    "a.exr has no Variance.R, Variance.G, Variance.B and count channels, expected "
                    "them or a picture of standard errors");
}

TEST_CASE("estimateFrom refuses standard errors that are none", "[stats]") {
  Image negative(1, 1);
  negative.rgb[1] = -1.0f;
  CHECK_THROWS_AS(estimateFrom(Image(1, 1), negative), UsageError);
  negative.rgb[1] = std::nanf("");
  CHECK_THROWS_AS(estimateFrom(Image(1, 1), negative), UsageError);
  CHECK_THROWS_AS(estimateFrom(Image(1, 1), Image(2, 1)), UsageError);
}

TEST_CASE("zMap is the difference in standard errors", "[stats]") {
  const ZMap map = zMap(estimateOf({1, 2, 3}, 3.0f), estimateOf({1, 7, -7}, 4.0f), 0.05);
  CHECK(map.z.rgb == std::vector<float>{0.0f, -1.0f, 2.0f});
  CHECK(map.rejectedFraction == 0.0);
}

TEST_CASE("zMap is exact where there is no error, empty where nothing is known", "[stats]") {
  const ZMap exact =
      zMap(estimateOf({1, 2, std::nanf("")}, 0.0f), estimateOf({1, 1, 1}, 0.0f), 0.05);
  CHECK(exact.z.rgb[0] == 0.0f);
  CHECK(std::isinf(exact.z.rgb[1]));
  CHECK(std::isnan(exact.z.rgb[2]));
  CHECK(exact.rejectedFraction == Approx(1.0 / 3.0));
  const ZMap unknown = zMap(estimateOf({1, 2, 3}, INFINITY), estimateOf({4, 5, 6}, 0.0f), 0.05);
  CHECK(unknown.z.rgb == std::vector<float>{0.0f, 0.0f, 0.0f});
  CHECK(unknown.rejectedFraction == 0.0);
}

TEST_CASE("zMap refuses sizes that differ and rates out of range", "[stats]") {
  const ImageEstimate one = estimateOf({1, 1, 1}, 1.0f);
  CHECK_THROWS_AS(zMap(one, estimateOf({1, 1, 1, 1, 1, 1}, 1.0f), 0.05), UsageError);
  CHECK_THROWS_AS(zMap(one, one, 0.5), UsageError);
}
