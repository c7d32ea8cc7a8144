#include "common/stats/batch_means.h"

#include <cmath>
#include <limits>

#include "common/base/error.h"
#include "tests/catch.h"

using namespace twintrace;

TEST_CASE("BlockGrid keeps partial blocks at the borders", "[stats]") {
  const BlockGrid grid{17, 9};
  CHECK(grid.columns() == 3);
  CHECK(grid.rows() == 2);
  CHECK(grid.blockOf(0) == 0);
  CHECK(grid.blockOf(7 * 17 + 7) == 0);
  CHECK(grid.blockOf(8) == 1);
  CHECK(grid.blockOf(8 * 17 + 16) == 5);
  CHECK(grid.corner(5) == PixelPosition{16, 8});
}

TEST_CASE("BatchMeans averages each block and the picture", "[stats]") {
  Image image(9, 1);
  for (std::size_t i = 0; i < 9; ++i) image.rgb[i * 3] = static_cast<float>(i);
  BatchMeans batches(9, 1);
  batches.add(image);
  CHECK(batches.batchCount() == 1);
  CHECK(batches.blockMeans(0)[0] == 3.5);
  CHECK(batches.blockMeans(0)[3] == 8.0);
  CHECK(batches.imageMean(0)[0] == 4.0);
  CHECK(batches.imageMean(0)[1] == 0.0);
}

TEST_CASE("BatchMeans leaves out and counts values that are not finite", "[stats]") {
  Image image(9, 1);
  image.rgb.assign(27, 2.0f);
  image.rgb[0] = std::numeric_limits<float>::infinity();
  image.rgb[24] = std::numeric_limits<float>::quiet_NaN();
  BatchMeans batches(9, 1);
  batches.add(image);
  CHECK(batches.nonFiniteValues() == 2);
  CHECK(batches.blockMeans(0)[0] == 2.0);
  CHECK(std::isnan(batches.blockMeans(0)[3]));
}

TEST_CASE("BatchMeans refuses a batch of another size", "[stats]") {
  BatchMeans batches(9, 1);
  CHECK_THROWS_AS(batches.add(Image(1, 9)), UsageError);
}
