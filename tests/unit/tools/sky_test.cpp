#include "experiments/tools/sky.h"

#include <cstring>

#include "common/film/image_io.h"
#include "tests/catch.h"

namespace twintrace {

// Pixels, not file bytes: how ZIP packs them is up to the library's version.
TEST_CASE("the committed sky is what makeSky makes", "[tools]") {
  const Image made = makeSky();
  const Image committed =
      readExr(std::string(TWINTRACE_SOURCE_DIR) + "/experiments/scenes/sky.exr").image;
  REQUIRE(made.sameSize(committed));
  CHECK(std::memcmp(made.rgb.data(), committed.rgb.data(), made.rgb.size() * sizeof(float)) == 0);
}

// u = 0.5 + atan2(z, x) / (2 pi), v = acos(y) / pi: the sun's pixel must be the brightest part.
TEST_CASE("makeSky puts the sun where kSunDirection points", "[tools]") {
  const Image sky = makeSky();
  const double u = 0.5 + std::atan2(kSunDirection.z, kSunDirection.x) / (2.0 * std::numbers::pi);
  const double v = std::acos(kSunDirection.y) / std::numbers::pi;
  const auto x = static_cast<std::size_t>(u * kSkyWidth);
  const auto y = static_cast<std::size_t>(v * kSkyHeight);
  const float brightest = *std::max_element(sky.rgb.begin(), sky.rgb.end());
  CHECK(sky.rgb[3 * (y * kSkyWidth + x)] == brightest);
}

TEST_CASE("roundedForFile keeps 11 bits of the significand", "[tools]") {
  CHECK(roundedForFile(0.0) == 0.0f);
  CHECK(roundedForFile(1.0) == 1.0f);
  CHECK(roundedForFile(1.0 + 0x1p-11) == 1.0f + 0x1p-10f);
  CHECK(roundedForFile(1.0 + 0x1p-12) == 1.0f);
  CHECK(roundedForFile(2.0 - 0x1p-23) == 2.0f);
}

}  // namespace twintrace
