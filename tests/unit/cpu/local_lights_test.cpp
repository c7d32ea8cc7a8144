#include <algorithm>

#include "tests/catch.h"
#include "tests/unit/cpu/render_fixtures.h"

using namespace twintrace;

namespace {

/// A floor seen from above under a local light, with something at the light's own place.
Scene floorUnder(const std::string& rest) {
  return parseScene(R"(
[camera]
eye = [0, 0.5, 0]
target = [0, 0, 0]
up = [0, 0, 1]
fov = 60
[materials.white]
albedo = [0.5, 0.5, 0.5]
[materials.black]
[[objects]]
shape = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "white"
)" + rest, "test.toml");
}

float darkest(const Scene& scene) {
  RenderOptions options = test::squareOptions(scene, 16, Integrator::path);
  options.bounces = 1;
  std::vector<float> sums(16 * 16 * 3);
  test::cpuRendererOf(scene, options)->renderFrame(0, 4, sums);
  return *std::min_element(sums.begin(), sums.end());
}

}  // namespace

TEST_CASE("path is not shadowed by what lies at the light itself", "[unit]") {
  const std::string lamp = R"(
[[lights]]
kind = "point"
position = [0.1, 1.3, 0.2]
intensity = [1, 1, 1]
)";
  CHECK(darkest(floorUnder(lamp + R"(
[[objects]]
shape = "plane"
point = [0, 1.3, 0]
normal = [0, 1, 0]
material = "black"
)")) > 0.0f);
  CHECK(darkest(floorUnder(lamp + R"(
[[objects]]
shape = "box"
min = [-2, 1.3, -2]
max = [2, 1.4, 2]
material = "black"
)")) > 0.0f);
}

TEST_CASE("path lights a point inside a sphere light from all sides", "[unit]") {
  // Within a sphere of radiance L the irradiance is pi L: intensity = L pi r^2, so that the floor
  // shows albedo * L = 0.5 * 1 / (pi 4) with intensity 1 and radius 2.
  const Scene scene = floorUnder(R"(
[[lights]]
kind = "sphere"
position = [0, 0, 0]
radius = 2
intensity = [1, 1, 1]
)");
  RenderOptions options = test::squareOptions(scene, 32, Integrator::path);
  options.bounces = 1;
  constexpr int kPasses = 256;
  std::vector<float> sums(32 * 32 * 3);
  test::cpuRendererOf(scene, options)->renderFrame(0, kPasses, sums);
  double mean = 0;
  for (const float sum : sums) mean += sum / (kPasses * double(sums.size()));
  // 2^18 samples of cos over the sphere, relative deviation 0.85 each way: 5 sigma is below 1 %.
  CHECK(mean == Approx(0.5 / (4.0 * 3.14159265358979)).epsilon(0.01));
}
