// Every sampler of the kernel against its density, by chi-square on bins of solid angle or area.
// All tests of this file are one family: a right program fails any of them, by chance, for
// kFamilyAlpha of all seeds. Seeds are fixed.

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <random>

#include "common/scene/flat_scene.h"
#include "common/stats/chi_square.h"
#include "cpu/kernel/light.h"
#include "cpu/kernel/material.h"
#include "cpu/kernel/path_state.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

using Vec = kernel::Vec3<float>;
constexpr double kPi = std::numbers::pi;
constexpr double kTwoPi = 2.0 * kPi;

constexpr double kFamilyAlpha = 1e-4;
constexpr int kFamilySize = 50;  // at most so many tests are made below
constexpr double kTestAlpha = kFamilyAlpha / kFamilySize;  // Bonferroni

constexpr int kDraws = 1000000;
constexpr int kRings = 40;     // bins of the angle to the axis
constexpr int kSectors = 24;   // bins of the azimuth

/// Rounding of a direction's angles, radians; a draw at the rim may be so far outside.
constexpr double kAngleRounding = 1e-6;

void checkFit(const ChiSquare& fit) {
  INFO("chi-square " << fit.statistic << " with " << fit.dof << " degrees of freedom, p = "
                     << fit.p);
  CHECK(fit.dof > 50);
  CHECK(fit.p > kTestAlpha);
}

/// Uniform numbers in [0, 1) with 24 bits, as the tracers' are.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : random_(seed) {}
  float operator()() { return static_cast<float>(random_() >> 40) * 0x1p-24f; }

 private:
  std::mt19937_64 random_;
};

using Draw = std::function<Vec(float u, float v)>;
using Density = std::function<double(double cosine)>;  ///< per solid angle

glm::dvec3 widened(const Vec& v) { return {double{v.x}, double{v.y}, double{v.z}}; }

/// Right-handed axes of which the third is n; another construction than tangentToWorld's.
struct Axes {
  glm::dvec3 x, y, z;

  explicit Axes(const Vec& n) : z(glm::normalize(widened(n))) {
    const bool steep = std::fabs(z.y) > 0.7;
    x = glm::normalize(glm::cross(steep ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), z));
    y = glm::cross(z, x);
  }
};

const Vec kUp(0.0f, 0.0f, 1.0f);

std::vector<double> evenAngles(double last) {
  std::vector<double> edges;
  for (int i = 0; i <= kRings; ++i) edges.push_back(last * i / kRings);
  return edges;
}

/// Edges dense where a lobe of this width is, tan(angle) = width * tan(even angle).
std::vector<double> lobeAngles(double width) {
  std::vector<double> edges = evenAngles(kPi / 2.0);
  for (int i = 1; i < kRings; ++i) {
    edges[static_cast<std::size_t>(i)] =
        std::atan(width * std::tan(edges[static_cast<std::size_t>(i)]));
  }
  return edges;
}

/// Chance of a ring by the midpoint rule; off by less than 1e-8 for the densities here.
double ringChance(const Density& density, double from, double to) {
  constexpr int kSteps = 1000;
  const double step = (to - from) / kSteps;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = from + (i + 0.5) * step;
    sum += density(std::cos(angle)) * std::sin(angle);
  }
  return sum * step * kTwoPi;
}

/// Counts of draws per ring and sector; what lies beyond the last edge goes to a last bin, which
/// expects nothing.
std::vector<std::uint64_t> countDirections(const Draw& draw, const std::vector<double>& edges,
                                           const Axes& axes, std::uint64_t seed) {
  std::vector<std::uint64_t> counts(kRings * kSectors + 1);
  Uniform random(seed);
  for (int i = 0; i < kDraws; ++i) {
    const float u = random();
    const float v = random();
    const glm::dvec3 d = widened(draw(u, v));
    const double x = glm::dot(d, axes.x);
    const double y = glm::dot(d, axes.y);
    const double angle = std::atan2(std::hypot(x, y), glm::dot(d, axes.z));
    if (angle > edges.back() + kAngleRounding) {
      ++counts.back();
      continue;
    }
    const auto next = std::upper_bound(edges.begin() + 1, edges.end() - 1, angle);
    const auto ring = static_cast<std::size_t>(next - edges.begin() - 1);
    const double turns = std::atan2(y, x) / kTwoPi + 0.5;
    const auto sector = std::min(static_cast<std::size_t>(turns * kSectors),
                                 std::size_t{kSectors - 1});
    ++counts[ring * kSectors + sector];
  }
  return counts;
}

ChiSquare fitDirections(const Draw& draw, const Density& density, const std::vector<double>& edges,
                        const Vec& axis = kUp, std::uint64_t seed = 1) {
  std::vector<double> expected;
  for (int ring = 0; ring < kRings; ++ring) {
    const auto i = static_cast<std::size_t>(ring);
    const double chance = ringChance(density, edges[i], edges[i + 1]);
    expected.insert(expected.end(), kSectors, chance * kDraws / kSectors);
  }
  expected.push_back(0.0);
  return chiSquareTest(countDirections(draw, edges, Axes(axis), seed), expected);
}

double cosineDensity(double cosine) { return kernel::pdfCosineHemisphere<double>(cosine); }

Density powerDensity(float exponent) {
  return [=](double cosine) { return kernel::pdfPowerHemisphere<double>(exponent, cosine); };
}

/// A width that spreads a power lobe over the rings: its cosine has 1 - mean = 1 / (exponent + 2).
std::vector<double> powerAngles(float exponent) {
  return lobeAngles(std::sqrt(2.0 / (double{exponent} + 2.0)));
}

}  // namespace

TEST_CASE("sampleCosineHemisphere follows its density", "[statistical][samplers]") {
  const Draw draw = [](float u, float v) { return kernel::sampleCosineHemisphere(u, v); };
  checkFit(fitDirections(draw, cosineDensity, evenAngles(kPi / 2.0)));
}

TEST_CASE("samplePowerHemisphere follows its density", "[statistical][samplers]") {
  for (const float exponent : {0.0f, 0.5f, 1.0f, 10.0f, 31.6f, 1000.0f}) {
    INFO("exponent " << exponent);
    const Draw draw = [=](float u, float v) {
      return kernel::samplePowerHemisphere(1.0f / (exponent + 1.0f), u, v);
    };
    checkFit(fitDirections(draw, powerDensity(exponent), powerAngles(exponent)));
  }
}

TEST_CASE("sampleCone follows its density", "[statistical][samplers]") {
  for (const float height : {1e-5f, 0.01f, 0.3f, 1.0f, 1.7f}) {
    INFO("height " << height);
    const double rim = 2.0 * std::asin(std::sqrt(double{height} / 2.0));
    const Draw draw = [=](float u, float v) { return kernel::sampleCone(height, u, v); };
    const Density density = [=](double cosine) {
      return kernel::pdfCone<double>(double{height}, cosine);
    };
    checkFit(fitDirections(draw, density, evenAngles(rim)));
  }
}

TEST_CASE("sampleGgxNormal follows its density", "[statistical][samplers]") {
  for (const float alpha : {0.01f, 0.1f, 0.3f, 0.7f, 1.0f}) {
    INFO("alpha " << alpha);
    const Draw draw = [=](float u, float v) { return kernel::sampleGgxNormal(alpha, u, v); };
    const Density density = [=](double cosine) {
      return kernel::pdfGgxNormal<double>(double{alpha}, cosine);
    };
    checkFit(fitDirections(draw, density, lobeAngles(double{alpha})));
  }
}

TEST_CASE("tangentToWorld turns a hemisphere to any normal", "[statistical][samplers]") {
  const float x = 0.99f;
  for (const Vec& n :
       {Vec(1.0f, 0.0f, 0.0f), Vec(-1.0f, 0.0f, 0.0f), Vec(0.0f, 1.0f, 0.0f),
        Vec(0.0f, 0.0f, -1.0f), Vec(x, std::sqrt(1.0f - x * x), 0.0f),
        Vec(0.48f, -0.6f, 0.64f)}) {
    INFO("normal " << n.x << " " << n.y << " " << n.z);
    const Draw draw = [=](float u, float v) {
      return kernel::tangentToWorld(n, kernel::sampleCosineHemisphere(u, v));
    };
    checkFit(fitDirections(draw, cosineDensity, evenAngles(kPi / 2.0), n));
  }
}

// About the mirrored ray the lobe is a power of the cosine; its part below the surface weighs 0.
TEST_CASE("samplePhong samples about the mirrored ray", "[statistical][samplers]") {
  const Vec d(0.6f, 0.0f, -0.8f);
  const Vec mirrored(0.6f, 0.0f, 0.8f);
  for (const float exponent : {1.0f, 10.0f, 1000.0f}) {
    INFO("exponent " << exponent);
    const float inverse = 1.0f / (exponent + 1.0f);
    const Draw draw = [=](float u, float v) {
      return kernel::samplePhong(kUp, d, 1.0f, inverse, Vec(1.0f), u, v).direction;
    };
    checkFit(fitDirections(draw, powerDensity(exponent), powerAngles(exponent), mirrored));
  }
}

// The half vector tells which normal was drawn: between them and the ray the angle is below 90
// degrees unless the normal faces away, which for this ray needs one more than 53 degrees off;
// seen edge-on the half vector is the opposite one.
TEST_CASE("sampleGgx mirrors the ray at GGX normals", "[statistical][samplers]") {
  const Vec d(0.6f, 0.0f, -0.8f);
  for (const float alpha : {0.1f, 0.5f, 1.0f}) {
    INFO("alpha " << alpha);
    const Draw draw = [=](float u, float v) {
      const Vec i = kernel::sampleGgx(kUp, d, alpha, Vec(1.0f), u, v).direction;
      const Vec h = kernel::normalize3(i - d);
      return h.z < 0.0f ? -h : h;
    };
    const Density density = [=](double cosine) {
      return kernel::pdfGgxNormal<double>(double{alpha}, cosine);
    };
    checkFit(fitDirections(draw, density, lobeAngles(double{alpha})));
  }
}

TEST_CASE("sampleSphereLight is uniform over the cone that the light fills",
          "[statistical][samplers]") {
  const Vec position(1.0f, 2.0f, -0.5f);
  for (const float radius : {0.01f, 1.0f, 2.0f}) {
    INFO("radius " << radius);
    kernel::Light<float> light{};
    light.position = Vec(0.0f, 0.0f, 0.5f);
    light.radius = radius;
    const Vec towards = light.position - position;
    const double sine = double{radius} / glm::length(widened(towards));
    const Draw draw = [=](float u, float v) {
      return kernel::sampleSphereLight(light, position, u, v).direction;
    };
    const double solidAngle = kTwoPi * (1.0 - std::cos(std::asin(sine)));
    checkFit(fitDirections(draw, [=](double) { return 1.0 / solidAngle; },
                           evenAngles(std::asin(sine)), towards));
  }
}

TEST_CASE("sampleSunLight is uniform over the sun's disk", "[statistical][samplers]") {
  kernel::Light<float> light{};
  light.position = Vec(0.48f, 0.6f, 0.64f);
  light.height = 0.02f;
  const double rim = 2.0 * std::asin(std::sqrt(double{light.height} / 2.0));
  const Draw draw = [=](float u, float v) {
    return kernel::sampleSunLight(light, u, v).direction;
  };
  const double solidAngle = kTwoPi * double{light.height};
  checkFit(fitDirections(draw, [=](double) { return 1.0 / solidAngle; }, evenAngles(rim),
                         light.position));
}

// The test can fail: 5 % more exponent is seen.
TEST_CASE("a wrong density does not fit", "[statistical][samplers]") {
  const Draw draw = [](float u, float v) { return kernel::sampleCosineHemisphere(u, v); };
  CHECK(fitDirections(draw, powerDensity(1.05f), evenAngles(kPi / 2.0)).p < kTestAlpha);
}

namespace {

constexpr int kCells = 32;  // bins each way of a square

/// Counts of points in the unit square; those outside by rounding count in the outermost cells.
class SquareCounts {
 public:
  void add(double x, double y) { ++counts_[cell(y) * kCells + cell(x)]; }

  ChiSquare fitUniform() const {
    std::uint64_t total = 0;
    for (const std::uint64_t count : counts_) total += count;
    const std::vector<double> expected(counts_.size(), double(total) / double(counts_.size()));
    return chiSquareTest(counts_, expected);
  }

 private:
  static std::size_t cell(double x) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(x * kCells), 0, kCells - 1));
  }

  std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(kCells * kCells);
};

/// Equal areas of the unit disk as equal areas of the unit square.
void addDiskPoint(SquareCounts& counts, double x, double y) {
  counts.add(x * x + y * y, std::atan2(y, x) / kTwoPi + 0.5);
}

/// A camera that looks along -z from the origin, with a film of 4 x 4 pixels and no object.
struct CameraScene {
  explicit CameraScene(float aperture) {
    Scene scene;
    scene.camera = {glm::vec3(0.0f), {0.0f, 0.0f, -1.0f}, {0.0f, 1.0f, 0.0f}, 90.0f, aperture, {}};
    options.width = kFilm;
    options.height = kFilm;
    flat = flatten(scene, options);
    view = kernel::viewScene(flat, options, nullptr);
  }

  kernel::SampleKey<float> key(int x, int y, std::uint32_t sample) const {
    return kernel::makeSampleKey<float>(view, x, y, kFilm, sample, 7u);
  }

  static constexpr int kFilm = 4;
  RenderOptions options;
  FlatScene flat;
  kernel::SceneView view;
};

constexpr std::uint32_t kSamples = 20000;  // per pixel of CameraScene

/// Calls `use(x, y, key)` for all samples of all pixels.
template <class Use>
void forAllSamples(const CameraScene& scene, Use use) {
  for (std::uint32_t sample = 0; sample < kSamples; ++sample) {
    for (int y = 0; y < CameraScene::kFilm; ++y) {
      for (int x = 0; x < CameraScene::kFilm; ++x) use(x, y, scene.key(x, y, sample));
    }
  }
}

}  // namespace

TEST_CASE("sampleDisk is uniform over the unit disk", "[statistical][samplers]") {
  SquareCounts counts;
  Uniform random(2);
  for (int i = 0; i < kDraws; ++i) {
    const float u = random();
    const float v = random();
    const Vec point = kernel::sampleDisk(u, v);
    addDiskPoint(counts, double{point.x}, double{point.y});
  }
  checkFit(counts.fitUniform());
}

// The film is 2 x 2 at distance 1: a pixel is half a unit wide.
TEST_CASE("cameraRay is uniform over the pixel", "[statistical][samplers]") {
  const CameraScene scene(0.0f);
  SquareCounts counts;
  double farthest = 0.0;  // from the pixel's middle
  forAllSamples(scene, [&](int x, int y, const kernel::SampleKey<float>& key) {
    const glm::dvec3 d = widened(kernel::cameraRay<float>(scene.view, x, y, key).direction);
    const double column = (d.x / -d.z + 1.0) * 2.0 - x;
    const double row = (1.0 - d.y / -d.z) * 2.0 - y;
    farthest = std::max({farthest, std::fabs(column - 0.5), std::fabs(row - 0.5)});
    counts.add(column, row);
  });
  CHECK(farthest < 0.5 + kAngleRounding);
  checkFit(counts.fitUniform());
}

TEST_CASE("cameraRay is uniform over the lens", "[statistical][samplers]") {
  const CameraScene scene(0.5f);
  SquareCounts counts;
  forAllSamples(scene, [&](int x, int y, const kernel::SampleKey<float>& key) {
    const Vec origin = kernel::cameraRay<float>(scene.view, x, y, key).origin;
    addDiskPoint(counts, double{origin.x} / 0.25, double{origin.y} / 0.25);
  });
  checkFit(counts.fitUniform());
}

// Pairs that decide together: two dimensions, neighbouring samples, pixels and bounces.
TEST_CASE("pcg noise is uniform and independent in pairs", "[statistical][samplers]") {
  const CameraScene scene(0.0f);
  SquareCounts dimensions, samples, pixels, bounces;
  for (std::uint32_t sample = 0; sample < kSamples * 16; ++sample) {
    const auto key = scene.key(1, 2, sample);
    const auto drawn = [&](const kernel::SampleKey<float>& from, int bounce, int dimension) {
      return double{kernel::noise<float>(scene.view, from, bounce, dimension)};
    };
    const double u = drawn(key, 1, kernel::kDimensionDirectionU);
    dimensions.add(u, drawn(key, 1, kernel::kDimensionDirectionV));
    samples.add(u, drawn(scene.key(1, 2, sample + 1), 1, kernel::kDimensionDirectionU));
    pixels.add(u, drawn(scene.key(2, 2, sample), 1, kernel::kDimensionDirectionU));
    bounces.add(u, drawn(key, 2, kernel::kDimensionDirectionU));
  }
  checkFit(dimensions.fitUniform());
  checkFit(samples.fitUniform());
  checkFit(pixels.fitUniform());
  checkFit(bounces.fitUniform());
}

}  // namespace twintrace
