#include "cpu/embree_hull.h"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "common/base/error.h"
#include "common/base/flush_denormals.h"
#include "cpu/kernel/hit_surface.h"
#include "cpu/kernel/traverse.h"
#include "tests/catch.h"
#include "tests/unit/cpu/caster_fixtures.h"

namespace twintrace {
namespace {

using test::flatSceneOf;
using test::Shape;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();

/// Where and how large a test scene is.
struct Placement {
  const char* name;
  float scale;
  float shift;
};
constexpr Placement kPlacements[] = {
    {"unit", 1.0f, 0.0f}, {"tiny", 1e-4f, 0.0f}, {"large", 1e5f, 0.0f}, {"shifted", 1.0f, 1e6f}};

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  float between(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  float sign() { return below(2) == 0 ? -1.0f : 1.0f; }
  glm::vec3 inCube(float half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
  glm::vec3 direction() {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(engine_), normal(engine_), normal(engine_)));
  }
  /// +-2^-k for a random k in [low, high].
  float power(int low, int high) {
    return sign() * std::ldexp(1.0f, -(low + below(high - low + 1)));
  }

 private:
  std::mt19937 engine_;
};

// Spheres and boxes of very different sizes in [-4, 4]^3 on a lattice of 1/8, so that faces touch
// and axis-parallel rays lie in faces; some primitives twice, so that hits tie; a floor.
std::vector<Shape> mixedShapes(Random& random, const Placement& place) {
  const auto lattice = [](glm::vec3 v) { return glm::round(v * 8.0f) / 8.0f; };
  std::vector<Shape> shapes;
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 center = lattice(random.inCube(4.0f)) * place.scale + place.shift;
    const float size = std::ldexp(2.0f, -random.below(6)) * place.scale;
    const int copies = i % 10 == 0 ? 2 : 1;
    for (int copy = 0; copy < copies; ++copy) {
      if (i % 3 == 0) shapes.emplace_back(SphereShape{center, size});
      if (i % 3 == 1) shapes.emplace_back(BoxShape{center, glm::vec3(size, size, size * 0.5f), {}});
      if (i % 3 == 2) {
        shapes.emplace_back(BoxShape{center, glm::vec3(size), random.inCube(90.0f)});
      }
    }
  }
  shapes.emplace_back(PlaneShape{glm::vec3(place.shift - 3.0f * place.scale), {0, 1, 0}});
  return shapes;
}

/// One scene with the hull and the kernel's own loop over all primitives.
class Pair {
 public:
  Pair(std::shared_ptr<const FlatScene> scene, const RenderOptions& options)
      : scene_(std::move(scene)),
        view_(kernel::viewScene(*scene_, options, nullptr)),
        hull_(makeEmbreeHull(*scene_, options)) {}

  const kernel::SceneView& view() const { return view_; }

  CastHit byLoop(const CastRay& ray) const {
    const kernel::Ray<float> kernelRay = kernel::makeRay(
        kernel::toVec3(ray.origin), kernel::toVec3(ray.direction), ray.tmin, ray.tmax);
    const kernel::Hit<float> hit = kernel::closestHit(view_, kernelRay);
    if (hit.primitive == kernel::kNoPrimitive) return {};
    return {hit.t, hit.primitive, {}};
  }

  CastHit byHull(const CastRay& ray) const {
    float t = 0.0f;
    const HullQueryRay<float> query{{ray.origin.x, ray.origin.y, ray.origin.z},
                                    {ray.direction.x, ray.direction.y, ray.direction.z},
                                    ray.tmin,
                                    ray.tmax};
    const int primitive = hull_->closest(query, t);
    if (primitive == kernel::kNoPrimitive) return {};
    return {t, primitive, {}};
  }

 private:
  std::shared_ptr<const FlatScene> scene_;
  kernel::SceneView view_;
  std::unique_ptr<HullQuery> hull_;
};

bool sameBits(const CastHit& a, const CastHit& b) {
  return a.primitive == b.primitive && std::bit_cast<int>(a.t) == std::bit_cast<int>(b.t);
}

/// How many of `count` rays differ; the first three are reported. Sets FTZ and DAZ as the tracer.
template <class MakeRay>
int countDifferences(const Pair& pair, int count, const MakeRay& makeRay) {
  const FlushDenormals flush;
  int differences = 0;
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const CastRay ray = makeRay();
    const CastHit expected = pair.byLoop(ray);
    const CastHit found = pair.byHull(ray);
    hits += expected.valid();
    if (sameBits(expected, found)) continue;
    if (++differences <= 3) {
      WARN(test::hexText(ray) << ": loop " << test::hexText(expected) << ", hull "
                              << test::hexText(found));
    }
  }
  CHECK(hits > count / 100);
  return differences;
}

RenderOptions optionsOf(Intersector intersector) {
  RenderOptions options;
  options.intersector = intersector;
  return options;
}

/// Runs `family(pair, place, random)`, which returns differences, over all placements and both
/// intersectors.
template <class Family>
void expectSameHits(std::uint32_t seed, const Family& family) {
  for (const Placement& place : kPlacements) {
    for (const Intersector intersector : {Intersector::robust, Intersector::report}) {
      Random random(seed);
      const Pair pair(flatSceneOf(mixedShapes(random, place)), optionsOf(intersector));
      INFO(place.name << (intersector == Intersector::report ? ", report" : ", robust"));
      CHECK(family(pair, place, random) == 0);
    }
  }
}

glm::vec3 toGlm(const kernel::Vec3<float>& v) {
  return {v.x, v.y, v.z};
}

glm::vec3 perpendicular(const glm::vec3& d, Random& random) {
  return glm::normalize(glm::cross(d, random.direction()));
}

/// A ray past a sphere at its radius times 1 +- 2^-26..2^-6.
CastRay tangentRay(const Pair& pair, Random& random, float distance) {
  const int count = pair.view().index.sphereCount;
  const auto sphere = kernel::fetchSphere<float>(pair.view(), random.below(count));
  const glm::vec3 d = random.direction();
  const float aside = sphere.radius * (1.0f + random.power(6, 26));
  const glm::vec3 target = toGlm(sphere.center) + perpendicular(d, random) * aside;
  const glm::vec3 origin = target - d * (distance * random.between(0.0f, 1.0f));
  return {origin, d, 0.0f, kLargest};
}

/// A ray past a corner or an edge of a box.
CastRay edgeRay(const Pair& pair, Random& random, float distance) {
  const int count = pair.view().index.boxCount;
  const auto box = kernel::fetchBox<float>(pair.view(), random.below(count));
  const glm::vec3 low = toGlm(box.minimum);
  const glm::vec3 high = toGlm(box.maximum);
  glm::vec3 target;
  for (int axis = 0; axis < 3; ++axis) target[axis] = random.below(2) ? low[axis] : high[axis];
  const int along = random.below(6);  // 3 and beyond: the corner itself
  if (along < 3) target[along] = random.between(low[along], high[along]);
  const glm::vec3 d = random.direction();
  const float aside = (high.x - low.x) * random.power(6, 26);
  const glm::vec3 origin = target + perpendicular(d, random) * aside - d * distance;
  return {origin, d, 0.0f, kLargest};
}

/// A ray from a hit's surface, nearly along it or anywhere.
CastRay surfaceRay(const Pair& pair, const CastRay& from, Random& random) {
  const CastHit hit = pair.byLoop(from);
  if (!hit.valid()) return from;
  const auto ray = kernel::makeRay(kernel::toVec3(from.origin), kernel::toVec3(from.direction),
                                   from.tmin, from.tmax);
  const auto surface =
      kernel::surfaceAt(pair.view(), ray, kernel::Hit<float>{hit.t, hit.primitive});
  const glm::vec3 normal = toGlm(surface.normal);
  const float offset = surface.offset * float(random.below(3)) * 0.5f * random.sign();
  const glm::vec3 along = perpendicular(normal, random);
  const float height = random.below(2) ? random.power(0, 26) : 0.0f;
  const glm::vec3 d = glm::normalize(along + normal * height);
  return {toGlm(surface.position) + normal * offset, d, 0.0f, kLargest};
}

CastRay randomRay(const Placement& place, Random& random, float half) {
  const glm::vec3 origin = random.inCube(half) * place.scale + place.shift;
  return {origin, random.direction(), 0.0f, kLargest};
}

TEST_CASE("embree hull answers special rays as the loop", "[cpu][embree]") {
  Random random(1);
  const Pair pair(flatSceneOf(mixedShapes(random, kPlacements[0])), optionsOf(Intersector::robust));
  const FlushDenormals flush;
  const float values[] = {0.0f, -0.0f, 1e-40f, 1e-20f,   -1.0f,     1.0f,
                          2.5f, 1e6f,  -1e20f, kLargest, kInfinity, kNan};
  for (const float origin : values) {
    for (const float x : values) {
      for (const float y : values) {
        for (const float limit : values) {
          const CastRay ahead{{origin, 0.5f, -8.0f}, {x, y, 1.0f}, 0.0f, limit};
          const CastRay behind{{origin, 0.5f, 1.0f}, {x, y, -0.0f}, limit, kLargest};
          for (const CastRay& ray : {ahead, behind}) {
            const CastHit expected = pair.byLoop(ray);
            const CastHit found = pair.byHull(ray);
            INFO(test::hexText(ray)
                 << ": loop " << test::hexText(expected) << ", hull " << test::hexText(found));
            REQUIRE(sameBits(expected, found));
          }
        }
      }
    }
  }
}

TEST_CASE("embree hull gives ties to the lowest primitive", "[cpu][embree]") {
  const std::vector<Shape> shapes(9, SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f});
  const Pair pair(flatSceneOf(shapes), optionsOf(Intersector::robust));
  const CastHit hit = pair.byHull({{0.0f, 0.0f, -5.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, kLargest});
  CHECK(hit.primitive == 0);
  CHECK(hit.t == 4.0f);
}

TEST_CASE("embree hull's interval is closed", "[cpu][embree]") {
  const Pair pair(flatSceneOf({SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f}}),
                  optionsOf(Intersector::robust));
  const glm::vec3 origin(0.0f, 0.0f, -5.0f);
  const glm::vec3 direction(0.0f, 0.0f, 1.0f);
  CHECK(pair.byHull({origin, direction, 0.0f, 4.0f}).t == 4.0f);
  CHECK(pair.byHull({origin, direction, 4.0f, 4.0f}).t == 4.0f);
  CHECK(pair.byHull({origin, direction, 6.0f, 6.0f}).t == 6.0f);
  CHECK_FALSE(pair.byHull({origin, direction, 0.0f, std::nextafter(4.0f, 0.0f)}).valid());
  CHECK_FALSE(pair.byHull({origin, direction, std::nextafter(6.0f, 9.0f), 9.0f}).valid());
}

TEST_CASE("embree hull skips what the effects leave out", "[cpu][embree]") {
  const auto scene = flatSceneOf(
      {SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f}, BoxShape{{0.0f, 0.0f, 4.0f}, glm::vec3(2.0f), {}}});
  FlatScene changed = *scene;
  changed.effects.set(Effect::sphere, false);
  const Pair pair(std::make_shared<const FlatScene>(changed), optionsOf(Intersector::robust));
  CHECK(pair.byHull({{0.0f, 0.0f, -5.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, kLargest}).primitive == 1);
}

TEST_CASE("embree hull of a scene without bounded primitives sees its planes", "[cpu][embree]") {
  const Pair pair(flatSceneOf({PlaneShape{}}), optionsOf(Intersector::robust));
  CHECK(pair.byHull({{0.0f, 3.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, 0.0f, kLargest}).t == 3.0f);
}

TEST_CASE("embree hull refuses double precision", "[cpu][embree]") {
  RenderOptions options;
  options.precision = Precision::float64;
  CHECK_THROWS_AS(makeEmbreeHull(*flatSceneOf({SphereShape{}}), options), UsageError);
}

// Ray counts: 8 scenes each (4 placements, 2 intersectors), 4.4 million rays in all.

TEST_CASE("embree hull gives the loop's hits for random rays", "[cpu][embree]") {
  expectSameHits(11, [](const Pair& pair, const Placement& place, Random& random) {
    return countDifferences(pair, 100000, [&] { return randomRay(place, random, 6.0f); });
  });
}

TEST_CASE("embree hull gives the loop's hits for axis-parallel rays", "[cpu][embree]") {
  expectSameHits(12, [](const Pair& pair, const Placement& place, Random& random) {
    return countDifferences(pair, 50000, [&] {
      CastRay ray = randomRay(place, random, 6.0f);
      ray.origin = glm::round(random.inCube(6.0f) * 16.0f) / 16.0f * place.scale + place.shift;
      ray.direction = glm::vec3(0.0f * random.sign());
      ray.direction[random.below(3)] = random.sign();
      return ray;
    });
  });
}

TEST_CASE("embree hull gives the loop's hits for grazing rays", "[cpu][embree]") {
  expectSameHits(13, [](const Pair& pair, const Placement& place, Random& random) {
    return countDifferences(pair, 150000, [&] {
      const float distance = place.scale * (random.below(2) ? 4.0f : 60.0f);
      return random.below(2) ? tangentRay(pair, random, distance) : edgeRay(pair, random, distance);
    });
  });
}

TEST_CASE("embree hull gives the loop's hits for rays from surfaces", "[cpu][embree]") {
  expectSameHits(14, [](const Pair& pair, const Placement& place, Random& random) {
    return countDifferences(
        pair, 150000, [&] { return surfaceRay(pair, randomRay(place, random, 6.0f), random); });
  });
}

TEST_CASE("embree hull gives the loop's hits for far rays", "[cpu][embree]") {
  expectSameHits(15, [](const Pair& pair, const Placement& place, Random& random) {
    return countDifferences(pair, 50000, [&] {
      const float far = place.scale * std::ldexp(1.0f, random.below(21));
      return random.below(2) ? tangentRay(pair, random, far) : edgeRay(pair, random, far);
    });
  });
}

TEST_CASE("embree hull gives the loop's hits for directions of any length", "[cpu][embree]") {
  expectSameHits(16, [](const Pair& pair, const Placement& place, Random& random) {
    return countDifferences(pair, 25000, [&] {
      CastRay ray = tangentRay(pair, random, 4.0f * place.scale);
      ray.direction *= std::ldexp(random.between(1.0f, 2.0f), random.below(61) - 30);
      return ray;
    });
  });
}

TEST_CASE("embree hull gives the loop's hits for intervals that end at hits", "[cpu][embree]") {
  expectSameHits(17, [](const Pair& pair, const Placement& place, Random& random) {
    return countDifferences(pair, 25000, [&] {
      CastRay ray = randomRay(place, random, 6.0f);
      const CastHit hit = pair.byLoop(ray);
      if (!hit.valid()) return ray;
      const float end = random.below(2) ? hit.t : std::nextafter(hit.t, random.sign() * kLargest);
      (random.below(2) ? ray.tmin : ray.tmax) = end;
      return ray;
    });
  });
}

}  // namespace
}  // namespace twintrace
