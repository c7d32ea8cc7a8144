#include "common/hulls/tightness.h"
#include "cpu/hull_caster.h"
#include "tests/catch.h"
#include "tests/unit/hulls/hull_fixtures.h"

using namespace twintrace;
using namespace twintrace::test;

namespace {

constexpr int kLines = 400000;
/// The rays widen hulls by a slack, which adds so much to the areas of these.
constexpr double kWidening = 1e-3;

/// Lines without preference for any place or direction, as far as they come within a distance of the
/// origin.
std::vector<CastRay> isotropicLines(float distance, unsigned seed) {
  HullRandom random(seed);
  std::vector<CastRay> rays;
  while (rays.size() < kLines) {
    const glm::vec3 d = random.direction();
    const float x = random.uniform(-1.0f, 1.0f);
    const float y = random.uniform(-1.0f, 1.0f);
    if (x * x + y * y > 1.0f) continue;
    const glm::vec3 axis = std::fabs(d.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = glm::normalize(glm::cross(d, axis));
    const glm::vec3 v = glm::cross(d, u);
    rays.push_back({(u * x + v * y - d * 2.0f) * distance, d});
  }
  return rays;
}

Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{-0.5f, -0.4f, 0.3f}, {0.8f, -0.3f, 0.1f}, {0.0f, 0.9f, -0.2f}, {-0.1f, -0.1f, -0.8f}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return mesh;
}

double triangleArea(const Mesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](int i) { return glm::dvec3(mesh.positions[t[i]]); };
    area += 0.5 * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
  }
  return area;
}

struct Convex {
  Scene scene;
  double area;
};

std::vector<Convex> convexObjects() {
  std::vector<Convex> objects(3);
  for (Convex& object : objects) object.scene.materials.emplace_back();
  addObject(objects[0].scene, SphereShape{{0.1f, 0.0f, 0.0f}, 0.7f});
  objects[0].area = 4.0 * M_PI * 0.49;
  BoxShape box;
  box.size = {0.4f, 0.9f, 1.2f};
  box.rotation = {15.0f, 40.0f, 70.0f};
  addObject(objects[1].scene, box);
  objects[1].area = 2.0 * (0.4 * 0.9 + 0.9 * 1.2 + 1.2 * 0.4);
  addMesh(objects[2].scene, tetrahedron());
  objects[2].area = triangleArea(tetrahedron());
  return objects;
}

}  // namespace

TEST_CASE("hulls of convex objects are hit falsely as often as Crofton's formula says", "[hulls]") {
  const auto lines = isotropicLines(1.5f, 5);
  for (const Convex& object : convexObjects()) {
    for (const HullStrategy& strategy : hullStrategies()) {
      if (strategy.arrangement != HullArrangement::flat) continue;
      CAPTURE(strategy.name);
      const auto flat = flatWith(object.scene, strategy.name);
      HullCounts sum;
      for (const HullCounts& each : makeCpuHullCaster(flat, RenderOptions{})->count(lines)) {
        sum = sum + each;
      }
      const HullStructure& hulls = *flat->hulls;
      const double hullArea = hulls.volume.area(hulls.volume, hulls.record(0));
      const double expected = 1.0 - object.area / hullArea;
      const double observed = double(sum.falseHullHits) / sum.hullHits;
      const double deviation = std::sqrt(std::max(expected * (1.0 - expected), 1e-6) / sum.hullHits);
      CAPTURE(expected, observed, deviation, sum.hullHits);
      // What lies in both a box and a ball has an area of its own, below either's.
      if (strategy.name == "aabb+sphere") {
        CHECK(observed <= expected + 4.5 * deviation + kWidening);
      } else {
        CHECK(std::fabs(observed - expected) <= 4.5 * deviation + kWidening);
      }
      // And lines that meet the hull are as many as its area says.
      if (strategy.name == "aabb+sphere") continue;
      const double share = hullArea / (4.0 * M_PI * 1.5 * 1.5);
      const double spread = std::sqrt(share * (1.0 - share) / kLines);
      CHECK(std::fabs(double(sum.hullHits) / kLines - share) <= 4.5 * spread + kWidening * share);
    }
  }
}
