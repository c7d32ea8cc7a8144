// Embree's own geometry against the kernel on the rays of all shipped scenes: every difference must
// be explained by the bound on where a float engine's surface may be.

#include <array>
#include <cstdio>
#include <filesystem>
#include <random>

#include "common/scene/reader.h"
#include "cpu/embree_caster.h"
#include "common/base/flush_denormals.h"
#include "cpu/kernel/path_state.h"
#include "cpu/kernel/sampling.h"
#include "cpu/kernel/hit_surface.h"
#include "cpu/kernel/traverse.h"
#include "cpu/kernel_caster.h"
#include "tests/catch.h"
#include "tests/unit/cpu/caster_fixtures.h"
#include "tests/unit/cpu/hit_judge.h"

namespace twintrace {
namespace {

using test::HitJudge;
using test::Relation;

constexpr int kFilmWidth = 192;
constexpr int kFilmHeight = 144;

struct RayKind {
  const char* name;
  std::vector<CastRay> rays;
};

CastRay toCast(const kernel::Ray<float>& ray) {
  return {{ray.origin.x, ray.origin.y, ray.origin.z},
          {ray.direction.x, ray.direction.y, ray.direction.z},
          ray.tmin,
          ray.tmax};
}

kernel::Ray<float> toKernel(const CastRay& ray) {
  return kernel::makeRay(kernel::toVec3(ray.origin), kernel::toVec3(ray.direction), ray.tmin,
                         ray.tmax);
}

RayKind cameraRays(const kernel::SceneView& scene) {
  const kernel::Frame frame{kFilmWidth, 0, 1, 0, 1};
  RayKind result{"camera", {}};
  for (int y = 0; y < kFilmHeight; ++y) {
    for (int x = 0; x < kFilmWidth; ++x) {
      result.rays.push_back(toCast(kernel::beginSample<float>(scene, x, y, 0, frame).ray));
    }
  }
  return result;
}

/// Rays that leave the hits of `from` as the tracers' do, planes included.
/// @param turn the direction from the facing normal and the incoming direction
template <class Turn>
RayKind bounceRays(const char* name, const kernel::SceneView& scene, const RayKind& from,
                   const Turn& turn) {
  RayKind result{name, {}};
  for (const CastRay& incoming : from.rays) {
    const kernel::Ray<float> ray = toKernel(incoming);
    const kernel::Hit<float> hit = kernel::closestHit(scene, ray);
    if (hit.primitive == kernel::kNoPrimitive) continue;
    const auto surface = kernel::surfaceAt(scene, ray, hit);
    const auto normal = kernel::facingNormal(surface.normal, ray.direction);
    const auto origin = kernel::leavingOrigin(surface, normal);
    result.rays.push_back(
        toCast(kernel::makeRay(origin, turn(normal, ray.direction), 0.0f, kernel::kLargest)));
  }
  return result;
}

std::vector<RayKind> raysOf(const kernel::SceneView& scene) {
  const FlushDenormals flush;
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> number(0.0f, 1.0f);
  const auto diffuse = [&](const auto& normal, const auto&) {
    const float u = number(engine);
    return kernel::tangentToWorld(normal, kernel::sampleCosineHemisphere(u, number(engine)));
  };
  const auto mirror = [](const auto& normal, const auto& d) { return kernel::reflect3(d, normal); };
  std::vector<RayKind> kinds;
  kinds.push_back(cameraRays(scene));
  kinds.push_back(bounceRays("diffuse", scene, kinds[0], diffuse));
  kinds.push_back(bounceRays("mirror", scene, kinds[0], mirror));
  kinds.push_back(bounceRays("diffuse 2", scene, kinds[1], diffuse));
  kinds.push_back(bounceRays("mirror 2", scene, kinds[2], mirror));
  return kinds;
}

struct Account {
  std::array<long, test::kRelationCount> counts{};
  long hitCount = 0;
  double worstKernel = 0.0;  ///< distance of hits from their surface, in units of the bound
  double worstEmbree = 0.0;

  long operator[](Relation relation) const { return counts[static_cast<std::size_t>(relation)]; }
};

double residual(const kernel::SceneView& scene, const CastRay& ray, const CastHit& hit) {
  return hit.valid() ? test::residualOf(scene, ray, hit) : 0.0;
}

Account accountFor(const kernel::SceneView& scene, const RayKind& kind, RayCaster& kernelCaster,
                   RayCaster& embreeCaster) {
  const std::vector<CastHit> ours = kernelCaster.cast(kind.rays);
  const std::vector<CastHit> theirs = embreeCaster.cast(kind.rays);
  Account account;
  for (std::size_t i = 0; i < kind.rays.size(); ++i) {
    const CastRay& ray = kind.rays[i];
    const Relation relation = HitJudge(scene, ray).relate(ours[i], theirs[i]);
    ++account.counts[static_cast<std::size_t>(relation)];
    account.hitCount += ours[i].valid();
    account.worstKernel = std::max(account.worstKernel, residual(scene, ray, ours[i]));
    account.worstEmbree = std::max(account.worstEmbree, residual(scene, ray, theirs[i]));
    if (relation == Relation::unexplained && account[relation] <= 3) {
      WARN("unexplained: " << test::hexText(ray) << ": kernel " << test::hexText(ours[i])
                           << ", Embree " << test::hexText(theirs[i]));
    }
  }
  return account;
}

// Lines fit Catch's console width.
constexpr const char* kTableHead =
    "rays        count   hits  equal surface   tie silh. start unex.  ours embree\n";

std::string tableRow(const RayKind& kind, const Account& account) {
  char row[100];
  std::snprintf(row, sizeof row, "%-10s%7zu%7ld%7ld%8ld%6ld%6ld%6ld%6ld%6.3f%7.3f\n", kind.name,
                kind.rays.size(), account.hitCount, account[Relation::equal],
                account[Relation::sameSurface], account[Relation::nearTie],
                account[Relation::silhouette], account[Relation::startsOnSurface],
                account[Relation::unexplained], account.worstKernel, account.worstEmbree);
  return row;
}

FlatScene sceneWithoutPlanes(FlatScene scene) {
  scene.effects.set(Effect::plane, false);
  return scene;
}

TEST_CASE("Embree's geometry sees what the kernel sees in all shipped scenes", "[witness]") {
  std::string table;
  int sceneCount = 0;
  const std::filesystem::path folder =
      std::filesystem::path(TWINTRACE_SOURCE_DIR) / "experiments" / "scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    ++sceneCount;
    const Scene scene = readScene(entry.path());
    RenderOptions options = scene.render;
    options.width = kFilmWidth;
    options.height = kFilmHeight;
    options.precision = Precision::float32;
    options.maths = Maths::strict;
    options.intersector = Intersector::robust;
    const FlatScene full = flatten(scene, options);
    const auto bounded = std::make_shared<const FlatScene>(sceneWithoutPlanes(full));
    const auto view = kernel::viewScene(*bounded, options, nullptr);
    const auto kernelCaster = makeKernelCaster(bounded, options);
    const auto embreeCaster = makeEmbreeCaster(bounded);
    table += scene.name + "\n";
    for (const RayKind& kind : raysOf(kernel::viewScene(full, options, nullptr))) {
      const Account account = accountFor(view, kind, *kernelCaster, *embreeCaster);
      table += tableRow(kind, account);
      CHECK(account[Relation::unexplained] == 0);
    }
  }
  CHECK(sceneCount > 0);
  WARN(kTableHead << table);
}

/// Spheres and boxes of all sizes that overlap, one in ten of them twice.
std::shared_ptr<const FlatScene> crowd(std::mt19937& engine) {
  std::uniform_real_distribution<float> number(-1.0f, 1.0f);
  const auto vector = [&](float scale) {
    return glm::vec3(number(engine), number(engine), number(engine)) * scale;
  };
  std::vector<test::Shape> shapes;
  for (int i = 0; i < 90; ++i) {
    const glm::vec3 center = vector(4.0f);
    const float size = std::exp2(3.0f * number(engine) - 2.0f);
    if (i % 3 == 0) shapes.emplace_back(SphereShape{center, size});
    if (i % 3 == 1) shapes.emplace_back(BoxShape{center, glm::vec3(size), {}});
    if (i % 3 == 2) shapes.emplace_back(BoxShape{center, glm::vec3(size), vector(90.0f)});
    if (i % 10 == 0) shapes.push_back(shapes.back());
  }
  return test::flatSceneOf(shapes);
}

TEST_CASE("Embree's geometry sees what the kernel sees in a crowd", "[witness]") {
  std::mt19937 engine(3);
  const auto scene = crowd(engine);
  const kernel::SceneView view = kernel::viewScene(*scene, {}, nullptr);
  std::normal_distribution<float> normal;
  const auto vector = [&] { return glm::vec3(normal(engine), normal(engine), normal(engine)); };
  RayKind near{"near", {}};
  RayKind far{"far", {}};
  for (int i = 0; i < 50000; ++i) near.rays.push_back({vector() * 2.0f, vector()});
  for (int i = 0; i < 50000; ++i) {
    const glm::vec3 d = glm::normalize(vector());
    far.rays.push_back({vector() * 2.0f - d * 1000.0f, d});
  }
  std::string table;
  const auto kernelCaster = makeKernelCaster(scene, {});
  const auto embreeCaster = makeEmbreeCaster(scene);
  const auto anywhere = [&](const auto&, const auto&) { return kernel::toVec3(vector()); };
  for (const RayKind& kind : {near, far, bounceRays("surface", view, near, anywhere)}) {
    const Account account = accountFor(view, kind, *kernelCaster, *embreeCaster);
    table += tableRow(kind, account);
    CHECK(account[Relation::unexplained] == 0);
  }
  WARN(kTableHead << table);
}

/// One sphere of radius 1 at the origin; a box from 2 to 3 on x behind it.
struct JudgedScene {
  std::shared_ptr<const FlatScene> flat = test::flatSceneOf(
      {SphereShape{{0.0f, 0.0f, 0.0f}, 1.0f}, BoxShape{{2.5f, 0.0f, 0.0f}, glm::vec3(1.0f), {}}});
  kernel::SceneView view = kernel::viewScene(*flat, {}, nullptr);
};

TEST_CASE("HitJudge tells explained from unexplained hits", "[witness]") {
  const JudgedScene scene;
  const CastRay through{{-4.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
  const HitJudge judge(scene.view, through);
  const CastHit sphere{3.0f, 0, {}};
  CHECK(judge.relate(sphere, sphere) == Relation::equal);
  CHECK(judge.relate(sphere, {3.000005f, 0, {}}) == Relation::sameSurface);
  CHECK(judge.relate(sphere, {3.00002f, 0, {}}) == Relation::unexplained);
  CHECK(judge.relate(sphere, {5.0f, 0, {}}) == Relation::unexplained);
  CHECK(judge.relate(sphere, {6.0f, 1, {}}) == Relation::unexplained);
  CHECK(judge.relate(sphere, {}) == Relation::unexplained);
}

TEST_CASE("HitJudge allows a miss at the silhouette alone", "[witness]") {
  const JudgedScene scene;
  const auto relate = [&](float height, const CastHit& a, const CastHit& b) {
    const CastRay past{{-4.0f, height, 0.0f}, {1.0f, 0.0f, 0.0f}};
    return HitJudge(scene.view, past).relate(a, b);
  };
  const CastHit tangent{4.0f, 0, {}};
  CHECK(relate(1.000005f, tangent, {}) == Relation::silhouette);
  CHECK(relate(1.001f, tangent, {}) == Relation::unexplained);
  CHECK(relate(0.999f, {4.0f - std::sqrt(1.0f - 0.998001f), 0, {}}, {}) == Relation::unexplained);
}

TEST_CASE("HitJudge allows either hit where a ray begins on a surface", "[witness]") {
  const JudgedScene scene;
  const CastRay leaving{{1.000001f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
  const CastHit box{1.0f, 1, {}};
  CHECK(HitJudge(scene.view, leaving).relate(box, {0.0f, 0, {}}) == Relation::startsOnSurface);
  const CastRay clear{{1.001f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
  CHECK(HitJudge(scene.view, clear).relate({0.999f, 1, {}}, {0.0f, 0, {}}) ==
        Relation::unexplained);
}

TEST_CASE("HitJudge calls two primitives at one distance a near tie", "[witness]") {
  const auto flat = test::flatSceneOf({BoxShape{{0.0f, 0.0f, 0.0f}, glm::vec3(2.0f), {}},
                                       BoxShape{{0.5f, 0.0f, 0.0f}, glm::vec3(3.0f), {}}});
  const kernel::SceneView view = kernel::viewScene(*flat, {}, nullptr);
  const CastRay ray{{-4.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
  CHECK(HitJudge(view, ray).relate({3.0f, 0, {}}, {3.0f, 1, {}}) == Relation::nearTie);
}

}  // namespace
}  // namespace twintrace
