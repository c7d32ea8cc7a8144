// Pictures and lobes whose radiance is known in closed form.

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "cpu/kernel/hash.h"
#include "cpu/kernel/light.h"
#include "cpu/kernel/material.h"
#include "tests/catch.h"
#include "tests/unit/cpu/render_fixtures.h"

namespace twintrace {
namespace {

constexpr double kPi = std::numbers::pi;

/// Standard errors that a mean may be off: a right one is by chance in 6e-7 of all seeds. About 100
/// means are tested here, with fixed seeds.
constexpr double kSigmas = 5.0;

constexpr int kSize = 40;  // pixels
constexpr int kPasses = 16;

/// The four arms of the CPU tracer.
std::vector<RenderOptions> armsOf(const RenderOptions& base) {
  std::vector<RenderOptions> arms(4, base);
  arms[1].lanes = Lanes::scalar;
  arms[2].maths = Maths::native;
  arms[3].precision = Precision::float64;
  return arms;
}

RenderOptions furnaceOptions(const Scene& scene, Integrator integrator) {
  RenderOptions options = test::squareOptions(scene, kSize, integrator);
  options.passes = kPasses;
  return options;
}

/// Whether all of a pixel sees the ball of the furnace scenes: radius 1, straight ahead at distance
/// 4. Its outline is a circle, so that the corners tell.
bool isCovered(const Scene& scene, int x, int y) {
  const double step = 2.0 * std::tan(scene.camera.fov * kPi / 360.0) / kSize;
  const double rim = std::tan(std::asin(1.0 / 4.0));
  const double dx = std::fabs(x + 0.5 - kSize / 2.0) + 0.5;
  const double dy = std::fabs(y + 0.5 - kSize / 2.0) + 0.5;
  return std::hypot(dx, dy) * step < rim;
}

/// Mean radiance of each pixel, all channels of it, that sees nothing but the ball.
std::vector<double> ballValues(const Scene& scene, const RenderOptions& options) {
  const auto sums = test::frameSums(scene, options);
  std::vector<double> values;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (!isCovered(scene, x, y)) continue;
      for (int c = 0; c < 3; ++c) {
        values.push_back(double{sums[static_cast<std::size_t>(3 * (y * kSize + x) + c)]} / kPasses);
      }
    }
  }
  REQUIRE(values.size() > 1500);
  return values;
}

bool allEqual(const std::vector<double>& values, double expected) {
  return std::all_of(values.begin(), values.end(), [&](double v) { return v == expected; });
}

/// Whether an estimate agrees with a value that is itself known to within `slack`.
void checkMean(const test::Estimate& estimate, double expected, double slack = 0.0) {
  INFO("mean " << estimate.mean << " +- " << estimate.error << ", expected " << expected);
  CHECK(std::fabs(estimate.mean - expected) <= kSigmas * estimate.error + slack);
}

}  // namespace

// The weight albedo / chance is 0.5 and the sky 1, both exact in binary, and so are sums of them:
// the error bound is 0.
TEST_CASE("path reads 0.5 on a ball of albedo 0.5 in a white furnace", "[furnace]") {
  const Scene scene = test::shippedScene("furnace-diffuse");
  for (const RenderOptions& arm : armsOf(furnaceOptions(scene, Integrator::path))) {
    CHECK(allEqual(ballValues(scene, arm), 0.5));
  }
}

// The cosine counts twice: in the density of the direction and as a factor, so that 2/3 of the
// radiance is left, the mean cosine of a cosine-weighted direction. One channel is enough: the
// three are equal.
TEST_CASE("report reads 1/3 on a ball of albedo 0.5 in a white furnace", "[furnace]") {
  const Scene scene = test::shippedScene("furnace-diffuse");
  for (const RenderOptions& arm : armsOf(furnaceOptions(scene, Integrator::report))) {
    const auto values = ballValues(scene, arm);
    std::vector<double> red;
    for (std::size_t i = 0; i < values.size(); i += 3) red.push_back(values[i]);
    const test::Estimate estimate = test::estimateOf(red);
    checkMean(estimate, 1.0 / 3.0);
    CHECK(estimate.error < 0.002);
  }
}

TEST_CASE("path reads 1 on a mirror ball in a white furnace", "[furnace]") {
  const Scene scene = test::shippedScene("furnace-mirror");
  for (const RenderOptions& arm : armsOf(furnaceOptions(scene, Integrator::path))) {
    CHECK(allEqual(ballValues(scene, arm), 1.0));
  }
}

// Either lobe is chosen with chance 1/2 and then weighs 0.5 / 0.5.
TEST_CASE("path reads 1 on a ball that is half matt and half mirror", "[furnace]") {
  Scene scene = test::shippedScene("furnace-mirror");
  scene.materials[0].albedo = glm::vec3(0.5f);
  scene.materials[0].specular = glm::vec3(0.5f);
  for (const RenderOptions& arm : armsOf(furnaceOptions(scene, Integrator::path))) {
    CHECK(allEqual(ballValues(scene, arm), 1.0));
  }
}

TEST_CASE("a bounce limit of 0 shows emission alone", "[furnace]") {
  const Scene scene = test::shippedScene("furnace-diffuse");
  RenderOptions options = furnaceOptions(scene, Integrator::path);
  options.bounces = 0;
  CHECK(allEqual(ballValues(scene, options), 0.0));
}

// Inside a closed ball that glows with 0.5 and reflects half, k scattering events give the sum
// 0.5 (1 + 0.5 + ... + 0.5^k), exact in binary.
TEST_CASE("inside a glowing ball radiance is the sum over scattering events", "[furnace]") {
  Scene scene = test::shippedScene("furnace-diffuse");
  scene.materials[0].emission = glm::vec3(0.5f);
  scene.camera.eye = glm::vec3(0.0f, 0.0f, 0.5f);
  scene.environment.radiance = glm::vec3(0.0f);
  for (RenderOptions arm : armsOf(furnaceOptions(scene, Integrator::path))) {
    for (const int bounces : {0, 1, 5}) {
      arm.bounces = bounces;
      CHECK(allEqual(ballValues(scene, arm), 1.0 - std::exp2(-(bounces + 1))));
    }
  }
}

namespace {

using Vec = kernel::Vec3<float>;
constexpr std::size_t kDraws = 400000;

struct TestedLobe {
  std::string name;
  std::function<float(const Vec& d, float u, float v)> sample;          ///< weight
  std::function<float(const Vec& d, const Vec& towards)> evaluate;  ///< lobe times cosine
};

const Vec kUp(0.0f, 0.0f, 1.0f);
const Vec kWhite(1.0f);

TestedLobe ggxLobe(float alpha) {
  return {"ggx, alpha " + std::to_string(alpha),
          [=](const Vec& d, float u, float v) {
            return kernel::sampleGgx<float>(kUp, d, alpha, kWhite, u, v).weight.x;
          },
          [=](const Vec& d, const Vec& i) {
            return kernel::evaluateGgx<float>(kUp, d, i, alpha, kWhite).x;
          }};
}

TestedLobe phongLobe(float exponent) {
  const float scale = (exponent + 2.0f) / (exponent + 1.0f);
  const float inverse = 1.0f / (exponent + 1.0f);
  return {"phong, exponent " + std::to_string(exponent),
          [=](const Vec& d, float u, float v) {
            return kernel::samplePhong<float>(kUp, d, scale, inverse, kWhite, u, v).weight.x;
          },
          [=](const Vec& d, const Vec& i) {
            return kernel::evaluatePhong<float>(kUp, d, i, exponent, kWhite).x;
          }};
}

/// Unit direction of a ray that arrives at `degrees` from the normal.
Vec arriving(double degrees) {
  const double angle = degrees * kPi / 180.0;
  return {static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(-std::cos(angle))};
}

float unitNumber(std::uint32_t counter) {
  return kernel::unitFloat<float>(kernel::pcgHash(counter));
}

/// Share of the light from a direction that a lobe reflects, by sampling.
test::Estimate sampledAlbedo(const TestedLobe& lobe, const Vec& d) {
  std::vector<double> weights(kDraws);
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    weights[i] = double{lobe.sample(d, unitNumber(2 * i), unitNumber(2 * i + 1))};
  }
  return test::estimateOf(weights);
}

/// The same by the midpoint rule over the hemisphere, in cosine and azimuth.
double integratedAlbedo(const TestedLobe& lobe, const Vec& d) {
  constexpr int kCosines = 1500;
  constexpr int kAzimuths = 1000;
  double sum = 0.0;
  for (int a = 0; a < kAzimuths; ++a) {
    const double azimuth = 2.0 * kPi * (a + 0.5) / kAzimuths;
    for (int c = 0; c < kCosines; ++c) {
      const double cosine = (c + 0.5) / kCosines;
      const double sine = std::sqrt(1.0 - cosine * cosine);
      const Vec towards(static_cast<float>(sine * std::cos(azimuth)),
                        static_cast<float>(sine * std::sin(azimuth)), static_cast<float>(cosine));
      sum += double{lobe.evaluate(d, towards)};
    }
  }
  return sum * 2.0 * kPi / (double{kCosines} * kAzimuths);
}

/// Error of integratedAlbedo for lobes as wide as those here: halving the steps moves it by less.
constexpr double kQuadratureError = 1e-4;

}  // namespace

// The figure that Cycles' GGX gives as well: single scattering, separable masking.
TEST_CASE("a GGX lobe of roughness 1 reflects 0.4091 at 60 degrees", "[furnace]") {
  constexpr double kReference = 0.4091;
  constexpr double kReferenceError = 5e-5;
  const TestedLobe lobe = ggxLobe(1.0f);
  const Vec d = arriving(60.0);
  checkMean(sampledAlbedo(lobe, d), kReference, kReferenceError);
  CHECK(std::fabs(integratedAlbedo(lobe, d) - kReference) < kReferenceError + kQuadratureError);
}

TEST_CASE("glossy lobes reflect what their value integrates to, and at most 1", "[furnace]") {
  for (const TestedLobe& lobe : {ggxLobe(0.3f), ggxLobe(0.6f), ggxLobe(1.0f), phongLobe(1.0f),
                           phongLobe(8.0f), phongLobe(40.0f)}) {
    for (const double degrees : {0.0, 30.0, 60.0, 75.0}) {
      INFO(lobe.name << " at " << degrees << " degrees");
      const test::Estimate sampled = sampledAlbedo(lobe, arriving(degrees));
      checkMean(sampled, integratedAlbedo(lobe, arriving(degrees)), kQuadratureError);
      CHECK(sampled.mean <= 1.0 + kSigmas * sampled.error);
    }
  }
}

// scale * mean cosine = (n + 2) / (n + 1) * (n + 1) / (n + 2).
TEST_CASE("a Phong lobe reflects everything at normal incidence", "[furnace]") {
  for (const float exponent : {1.0f, 31.6f, 1000.0f}) {
    INFO("exponent " << exponent);
    checkMean(sampledAlbedo(phongLobe(exponent), arriving(0.0)), 1.0);
  }
}

namespace {

constexpr double kAlbedo = 0.6;

/// A camera that looks from above at one point of a matt plane, (1.5, 0, 0).
Scene litPlane(const Light& light) {
  Scene scene;
  scene.materials.emplace_back().albedo = glm::vec3(static_cast<float>(kAlbedo));
  scene.objects.push_back({"plane", PlaneShape{}, 0});
  scene.camera = {{1.5f, 4.0f, 0.0f}, {1.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 0.001f, 0.0f, {}};
  scene.lights.push_back(light);
  return scene;
}

/// The film sees 7e-5 units of the plane, over which the radiance from a light 2.5 away changes by
/// no more than 3 * 7e-5 / 2.5 = 8.4e-5 of its value; rounding adds about 1e-6.
constexpr double kSpotSlack = 1e-4;

test::Estimate planeRadiance(const Scene& scene, const RenderOptions& arm) {
  const auto sums = test::frameSums(scene, arm);
  std::vector<double> green;
  for (std::size_t i = 1; i < sums.size(); i += 3) green.push_back(double{sums[i]} / kPasses);
  return test::estimateOf(green);
}

/// Checks that the plane reflects `irradiance`, which must already hold the cosine.
void checkPlane(const Light& light, double irradiance) {
  const Scene scene = litPlane(light);
  const double expected = kAlbedo / kPi * irradiance;
  for (const RenderOptions& arm : armsOf(furnaceOptions(scene, Integrator::path))) {
    checkMean(planeRadiance(scene, arm), expected, expected * kSpotSlack);
  }
}

/// Two above the plane, 1.5 beside the point: 2.5 away, cosine 0.8.
const glm::vec3 kLightPosition(0.0f, 2.0f, 0.0f);
const glm::vec3 kIntensity(1.0f, 5.0f, 9.0f);
constexpr double kGreen = 5.0;

}  // namespace

TEST_CASE("a point light gives I cos / d^2", "[furnace]") {
  checkPlane(PointLight{kLightPosition, kIntensity}, kGreen * 0.8 / 6.25);
}

// A uniform sphere that is wholly above the horizon gives the irradiance of a point in its middle.
TEST_CASE("a sphere light gives I cos / d^2 at any radius", "[furnace]") {
  for (const float radius : {0.001f, 0.5f, 1.9f}) {
    INFO("radius " << radius);
    checkPlane(SphereLight{kLightPosition, radius, kIntensity}, kGreen * 0.8 / 6.25);
  }
}

// Irradiance is that of a surface facing the sun; a wide sun's is its vector irradiance.
TEST_CASE("a sun light gives E cos at any angle", "[furnace]") {
  const glm::vec3 direction(3.0f, -4.0f, 0.0f);
  for (const float angle : {0.0f, 0.53f, 60.0f}) {
    INFO("angle " << angle);
    checkPlane(SunLight{direction, kIntensity, angle}, kGreen * 0.8);
  }
}

TEST_CASE("a ball in between puts the plane in the shadow of every light", "[furnace]") {
  const glm::vec3 direction(3.0f, -4.0f, 0.0f);
  for (const Light& light : {Light(PointLight{kLightPosition, kIntensity}),
                             Light(SphereLight{kLightPosition, 0.1f, kIntensity}),
                             Light(SunLight{direction, kIntensity, 1.0f})}) {
    Scene scene = litPlane(light);
    scene.objects.push_back({"ball", SphereShape{{0.75f, 1.0f, 0.0f}, 0.3f}, 0});
    RenderOptions options = furnaceOptions(scene, Integrator::path);
    options.bounces = 1;
    CHECK(planeRadiance(scene, options).mean == 0.0);
  }
}

}  // namespace twintrace
