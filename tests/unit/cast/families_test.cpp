#include "common/cast/families.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "common/base/error.h"
#include "common/base/finite.h"
#include "common/base/float_bits.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

bool sameVector(const glm::vec3& a, const glm::vec3& b) {
  return a == b && std::signbit(a.x) == std::signbit(b.x) &&
         std::signbit(a.y) == std::signbit(b.y) && std::signbit(a.z) == std::signbit(b.z);
}

bool sameRay(const CastRay& a, const CastRay& b) {
  return sameVector(a.origin, b.origin) && sameVector(a.direction, b.direction) &&
         a.tmin == b.tmin && a.tmax == b.tmax;
}

/// Whether two rays of case sets are the same with all that they see and how they bounce.
bool sameCase(const CaseSet& a, std::size_t i, const CaseSet& b, std::size_t k) {
  const auto inA = a.primitivesOf(a.rays[i]);
  const auto inB = b.primitivesOf(b.rays[k]);
  const auto samePrimitive = [](const CasePrimitive& p, const CasePrimitive& q) {
    return p.kind == q.kind && p.values == q.values;
  };
  return sameRay(a.rays[i].ray, b.rays[k].ray) &&
         std::equal(inA.begin(), inA.end(), inB.begin(), inB.end(), samePrimitive) &&
         a.bounces.empty() == b.bounces.empty() &&
         (a.bounces.empty() || a.bounces[i] == b.bounces[k]);
}

}  // namespace

TEST_CASE("families have names of their own and a line about them", "[cast]") {
  std::set<std::string> names;
  for (const Family& family : families()) {
    INFO(family.name);
    CHECK(names.insert(family.name).second);
    CHECK(family.name.size() <= 26);
    CHECK(!family.what.empty());
    CHECK(family.what.size() <= 72);
  }
}

TEST_CASE("drawFamily depends on name, count and seed alone", "[cast]") {
  for (const Family& family : families()) {
    INFO(family.name);
    const CaseSet a = drawFamily(family.name, 40, 7);
    const CaseSet longer = drawFamily(family.name, 80, 7);
    const CaseSet other = drawFamily(family.name, 40, 8);
    REQUIRE(a.rays.size() == 40);
    int sameAsOther = 0;
    for (std::size_t i = 0; i < a.rays.size(); ++i) {
      CHECK(sameRay(a.rays[i].ray, longer.rays[i].ray));
      CHECK(a.primitivesOf(a.rays[i])[0].values == longer.primitivesOf(longer.rays[i])[0].values);
      sameAsOther += sameRay(a.rays[i].ray, other.rays[i].ray);
    }
    CHECK(sameAsOther <= 10);
  }
}

TEST_CASE("a family drawn in parts has the rays of one drawn at once", "[cast]") {
  // Parts that begin and end within the rays of a shared scene, and one that goes over its end.
  constexpr std::uint32_t kParts[] = {1, 99, 100, 80};
  for (const Family& family : families()) {
    INFO(family.name);
    const CaseSet whole = drawFamily(family.name, 280, 5);
    std::uint32_t first = 0;
    for (const std::uint32_t count : kParts) {
      const CaseSet part = drawFamily(family.name, count, 5, first);
      REQUIRE(part.rays.size() == count);
      std::uint32_t same = 0;
      for (std::uint32_t i = 0; i < count; ++i) same += sameCase(part, i, whole, first + i);
      CHECK(same == count);
      first += count;
    }
    CHECK(first == whole.rays.size());
  }
}

TEST_CASE("a family of another seed has other scenes too", "[cast]") {
  int shared = 0;
  for (const Family& family : families()) {
    INFO(family.name);
    const CaseSet a = drawFamily(family.name, 40, 7);
    const CaseSet b = drawFamily(family.name, 40, 8);
    int same = 0;
    for (std::size_t i = 0; i < 40; ++i) same += sameCase(a, i, b, i);
    CHECK(same == 0);
    if (a.scenes.size() == a.rays.size()) continue;
    ++shared;
    CHECK(a.primitives.front().values != b.primitives.front().values);
  }
  CHECK(shared > 0);
}

TEST_CASE("drawFamily draws finite rays and primitives", "[cast]") {
  for (const Family& family : families()) {
    INFO(family.name);
    const CaseSet cases = drawFamily(family.name, 500, 1);
    for (const CaseRay& ray : cases.rays) {
      CHECK(isFinite(ray.ray.origin));
      CHECK(isFinite(ray.ray.direction));
      CHECK(ray.ray.direction != glm::vec3(0.0f));
      CHECK(ray.scene < cases.scenes.size());
      CHECK(!cases.primitivesOf(ray).empty());
    }
    for (const CasePrimitive& primitive : cases.primitives) {
      for (int i = 0; i < valueCount(primitive.kind); ++i)
        CHECK(std::isfinite(primitive.values[i]));
    }
  }
}

TEST_CASE("bounce families have a bounce for each ray, others none", "[cast]") {
  for (const Family& family : families()) {
    INFO(family.name);
    const CaseSet cases = drawFamily(family.name, 100, 1);
    CHECK(cases.bounces.size() == (family.kind == FamilyKind::bounce ? 100u : 0u));
    for (const Bounce& bounce : cases.bounces) {
      CHECK((bounce.x >= 0.0f && bounce.x < 1.0f && bounce.y >= 0.0f && bounce.y < 1.0f));
    }
  }
}

TEST_CASE("drawFamily shares an icosphere between rays", "[cast]") {
  const CaseSet cases = drawFamily("triangle-icosphere", 600, 1);
  CHECK(cases.scenes.size() == 3);
  CHECK(cases.primitives.size() == 3 * 320);
  CHECK(cases.rays[599].scene == 2);
}

TEST_CASE("the icosphere is closed: each edge belongs to two triangles", "[cast]") {
  const CaseSet cases = drawFamily("triangle-icosphere", 1, 1);
  using Point = std::array<float, 3>;
  const auto corner = [](const CasePrimitive& p, int i) {
    return Point{p.values[3 * i], p.values[3 * i + 1], p.values[3 * i + 2]};
  };
  std::set<std::pair<Point, Point>> edges;
  for (const CasePrimitive& p : cases.primitives) {
    for (int i = 0; i < 3; ++i) CHECK(edges.insert({corner(p, i), corner(p, (i + 1) % 3)}).second);
  }
  for (const auto& [from, to] : edges) CHECK(edges.count({to, from}) == 1);
}

TEST_CASE("exactly tangent rays touch their sphere in one point", "[cast]") {
  const CaseSet cases = drawFamily("sphere-tangent-exact", 200, 3);
  for (const CaseRay& ray : cases.rays) {
    const CasePrimitive& sphere = cases.primitivesOf(ray)[0];
    const glm::dvec3 l = glm::dvec3(sphere.vector(0)) - glm::dvec3(ray.ray.origin);
    const glm::dvec3 d(ray.ray.direction);
    const double along = l.x * d.x + l.y * d.y + l.z * d.z;
    const double distance2 = l.x * l.x + l.y * l.y + l.z * l.z - along * along;
    CHECK(distance2 == double(sphere.values[3]) * sphere.values[3]);
  }
}

TEST_CASE("findFamily suggests the nearest name", "[cast]") {
  CHECK(findFamily("box-edge").kind == FamilyKind::box);
  CHECK_THROWS_WITH(findFamily("box-egde"), Catch::Contains("did you mean 'box-edge'?"));
  CHECK_THROWS_AS(drawFamily("", 1, 1), UsageError);
}

}  // namespace twintrace
