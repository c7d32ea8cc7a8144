// The robust intersections, function by function, in float as the tracer runs them.

#include <cmath>
#include <functional>
#include <random>

#include "common/base/flush_denormals.h"
#include "cpu/kernel/surface.h"
#include "tests/catch.h"

namespace twintrace::kernel {
namespace {

using Vector = Vec3<float>;

constexpr std::uint64_t kSeed = 20240601;

Ray<float> rayFrom(Vector origin, Vector direction) {
  return makeRay(origin, direction, 0.0f, kLargest);
}

/// Random numbers with the shapes that these tests need.
class Draw {
 public:
  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector unit() {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double squared = 0.0;
    do {
      x = real(-1.0, 1.0);
      y = real(-1.0, 1.0);
      z = real(-1.0, 1.0);
      squared = x * x + y * y + z * z;
    } while (squared > 1.0 || squared < 1e-3);
    const double scale = 1.0 / std::sqrt(squared);
    return {static_cast<float>(x * scale), static_cast<float>(y * scale),
            static_cast<float>(z * scale)};
  }
  float size(double low, double high) { return static_cast<float>(real(low, high)); }

 private:
  std::mt19937_64 random_{kSeed};
};

OrientedBox<float> rotatedBox(Draw& draw, Vector center, float scale) {
  const Vector x = draw.unit();
  const Vector y = normalize3(cross3(x, draw.unit()));
  const Vector halfSize(scale * draw.size(0.1, 1.0), scale * draw.size(0.1, 1.0),
                        scale * draw.size(0.1, 1.0));
  return {center, x, y, cross3(x, y), halfSize};
}

float intersectOriented(const Ray<float>& ray, const OrientedBox<float>& box) {
  return intersectBoxRobust(toLocalRay(ray, box), toLocalBox(box));
}

/// The ray that leaves a surface on the side that `ray` came from, in a cosine-weighted direction.
Ray<float> bounced(Draw& draw, const Surface<float>& surface, const Ray<float>& ray) {
  const bool behind = dot3(surface.normal, ray.direction) > 0.0f;
  const Vector facing = behind ? -surface.normal : surface.normal;
  const Vector direction = normalize3(facing + draw.unit());
  return rayFrom(leavingOrigin(surface, facing), direction);
}

/// Casts rays from outside at random primitives of a scale about an offset, and counts those that
/// meet the same convex surface again after a bounce.
template <class Primitive>
int selfHits(double scale, double offset, const std::function<Primitive(Draw&, Vector)>& make,
             const std::function<float(const Ray<float>&, const Primitive&)>& intersect,
             const std::function<Surface<float>(const Ray<float>&, float, const Primitive&)>& surface) {
  constexpr int kBounces = 12500;
  Draw draw;
  int found = 0;
  for (int i = 0; i < kBounces; ++i) {
    const Vector center = draw.unit() * static_cast<float>(offset);
    const Primitive primitive = make(draw, center);
    const Vector direction = draw.unit();
    const Vector target = center + draw.unit() * static_cast<float>(0.3 * scale);
    const Ray<float> ray = rayFrom(target - direction * static_cast<float>(5.0 * scale), direction);
    const float t = intersect(ray, primitive);
    if (t > kLargest) continue;
    found += intersect(bounced(draw, surface(ray, t, primitive), ray), primitive) <= kLargest ? 1 : 0;
  }
  return found;
}

struct Cell {
  double scale, offset;
};
constexpr Cell kCells[] = {{1e-3, 0.0}, {1.0, 0.0},   {1e3, 0.0}, {1e6, 0.0},
                           {1.0, 1e3},  {1e3, 1e3}, {1e2, 1e6}, {1e6, 1e6}};

/// A surface with a plate at a gap above it is left below the plate: the offset is below the gap.
bool staysBelow(const Surface<float>& surface, double gap) { return surface.offset < 0.9 * gap; }

constexpr float kSpecial[] = {0.0f, -0.0f, 1.0f, -1.0f, 0.75f, 1e-30f, -1e-38f, 1e30f, -3e38f};

template <class Check>
void forSpecialVectors(const Check& check) {
  for (const float x : kSpecial) {
    for (const float y : kSpecial) {
      for (const float z : kSpecial) check(Vector(x, y, z));
    }
  }
}

bool isNumber(const Surface<float>& surface) {
  return !std::isnan(surface.normal.x + surface.normal.y + surface.normal.z);
}

}  // namespace

TEST_CASE("intersectSphereRobust hits a sphere that the ray touches") {
  const FlushDenormals flush;
  const Sphere<float> sphere{Vector(0.0f, 0.0f, 0.0f), 0.5f};
  CHECK(intersectSphereRobust(rayFrom(Vector(-4.0f, 0.5f, 0.0f), Vector(1.0f, 0.0f, 0.0f)), sphere) ==
        4.0f);
  const float above = std::nextafter(0.5f, 1.0f);
  CHECK(intersectSphereRobust(rayFrom(Vector(-4.0f, above, 0.0f), Vector(1.0f, 0.0f, 0.0f)), sphere) ==
        kInfinity);
}

TEST_CASE("intersectSphereRobust hits the far side from inside and leaves from the surface") {
  const FlushDenormals flush;
  const Sphere<float> sphere{Vector(1.0f, 0.0f, 0.0f), 2.0f};
  const Vector along(1.0f, 0.0f, 0.0f);
  CHECK(intersectSphereRobust(rayFrom(Vector(0.0f, 0.0f, 0.0f), along), sphere) == 3.0f);
  CHECK(intersectSphereRobust(rayFrom(Vector(-1.0f, 0.0f, 0.0f), -along), sphere) == 0.0f);
}

TEST_CASE("intersectSphereRobust takes lengths that have no squares") {
  const FlushDenormals flush;
  for (const float scale : {1e-30f, 1e-20f, 1e20f, 1e37f}) {
    const Sphere<float> sphere{Vector(3.0f * scale, 0.0f, 0.0f), scale};
    const float t = intersectSphereRobust(rayFrom(Vector(), Vector(1.0f, 0.0f, 0.0f)), sphere);
    CHECK(t / scale == Approx(2.0).epsilon(1e-6));
  }
}

TEST_CASE("sphereNormal knows the side of a sphere that is smaller than the distance's rounding") {
  const FlushDenormals flush;
  const Sphere<float> sphere{Vector(1e6f, 0.0f, 0.0f), 1e-3f};
  const Ray<float> ray = rayFrom(Vector(), Vector(1.0f, 0.0f, 0.0f));
  const Vector normal = sphereNormal(ray, intersectSphereRobust(ray, sphere), sphere);
  CHECK(normal.x == -1.0f);
}

TEST_CASE("intersectPlaneRobust finds a plane that is nearly parallel") {
  const FlushDenormals flush;
  // n.d is 2^-30, which float loses among terms of 1.
  const Plane<float> plane{Vector(0.0f, 0.0f, 0.0f), Vector(1.0f, 0x1p-30f, -1.0f)};
  const Ray<float> ray = rayFrom(Vector(-1.0f, 0.0f, 0.0f), Vector(1.0f, 1.0f, 1.0f));
  CHECK(intersectPlaneRobust(ray, plane) == 0x1p30f);
}

TEST_CASE("boxSurface has the near face's normal on a box without thickness") {
  const FlushDenormals flush;
  const Box<float> box{Vector(-1.0f, 0.0f, -1.0f), Vector(1.0f, 0.0f, 1.0f)};
  for (const float side : {-1.0f, 1.0f}) {
    const Ray<float> ray = rayFrom(Vector(0.1f, 2.0f * side, 0.2f), Vector(0.0f, -side, 0.0f));
    const float t = intersectBoxRobust(ray, box);
    CHECK(t == 2.0f);
    CHECK(boxSurface(ray, t, box).normal.y == side);
  }
}

TEST_CASE("boxSurface has the face that a ray from within or along a face leaves by") {
  const FlushDenormals flush;
  const Box<float> box{Vector(-1.0f, -1.0f, -1.0f), Vector(1.0f, 1.0f, 1.0f)};
  const auto normalFrom = [&](Vector origin, Vector direction) {
    const Ray<float> ray = rayFrom(origin, direction);
    return boxSurface(ray, intersectBoxRobust(ray, box), box).normal;
  };
  CHECK(normalFrom(Vector(0.0f), Vector(0.2f, -1.0f, 0.1f)).y == -1.0f);
  CHECK(normalFrom(Vector(-1.0f, 0.0f, 0.0f), Vector(1.0f, 0.1f, 0.0f)).x == -1.0f);
  // The slab of x gives NaN on one side.
  CHECK(normalFrom(Vector(1.0f, 0.0f, -3.0f), Vector(0.0f, 0.0f, 1.0f)).z == -1.0f);
  CHECK(normalFrom(Vector(1.0f, 0.0f, 0.5f), Vector(-0.0f, 1.0f, 0.0f)).y == 1.0f);
}

TEST_CASE("boxSurface has the face that is entered where rounding lets the ray leave before") {
  const FlushDenormals flush;
  Draw draw;
  int late = 0;
  int wrong = 0;
  for (int i = 0; i < 200000; ++i) {
    const Box<float> box{Vector(draw.size(-1, 0), draw.size(-1, 0), draw.size(-1, 0)),
                         Vector(draw.size(0, 1), draw.size(0, 1), draw.size(0, 1))};
    // Towards an edge, so that two slabs are met at the same place.
    const Vector edge(box.maximum.x, box.minimum.y, draw.size(-0.1, 0.1));
    const Vector direction = normalize3(Vector(draw.size(0.1, 1), draw.size(0.1, 1), 0.1f));
    const Ray<float> ray = rayFrom(edge - direction * draw.size(1, 5), direction);
    const Slabs<float> slabs = slabsOf(ray, box);
    const float t = intersectBoxRobust(ray, box);
    if (!(t <= kLargest) || slabs.entry <= slabs.exit) continue;
    ++late;
    wrong += dot3(boxSurface(ray, t, box).normal, direction) < 0.0f ? 0 : 1;
  }
  CHECK(late > 100);
  CHECK(wrong == 0);
}

TEST_CASE("a ray leaves a face at coordinate zero") {
  const FlushDenormals flush;
  const Box<float> box{Vector(0.0f, 0.0f, 0.0f), Vector(1.0f, 1.0f, 1.0f)};
  const Ray<float> ray = rayFrom(Vector(-2.0f, 0.5f, 0.5f), Vector(1.0f, 0.1f, 0.0f));
  const Surface<float> surface = boxSurface(ray, intersectBoxRobust(ray, box), box);
  CHECK(leavingOrigin(surface, surface.normal).x < 0.0f);
}

TEST_CASE("a box's offset goes by the hit face's coordinate alone") {
  const FlushDenormals flush;
  const Box<float> box{Vector(-1e6f, 0.0f, -1e6f), Vector(1e6f, 1.0f, 1e6f)};
  const Ray<float> ray = rayFrom(Vector(5e5f, 3.0f, 2e5f), Vector(0.0f, -1.0f, 0.0f));
  CHECK(boxSurface(ray, intersectBoxRobust(ray, box), box).offset < 0x3p-24f);
}

TEST_CASE("the report's surfaces are the point at t, its offset fixed") {
  SceneView scene;
  scene.intersectorReport = true;
  const Ray<float> ray = rayFrom(Vector(0.1f, 3.0f, 0.2f), Vector(0.0f, -1.0f, 0.0f));
  const Vector zero(0.0f);
  const Vector one(1.0f);
  const OrientedBox<float> oriented{zero, Vector(0.8f, 0.6f, 0.0f), Vector(-0.6f, 0.8f, 0.0f),
                                    Vector(0.0f, 0.0f, 1.0f), one};
  const Triangle<float> triangle{Vector(-1.0f, 0.0f, -1.0f), Vector(1.0f, 0.1f, -1.0f),
                                 Vector(0.0f, 0.0f, 1.0f)};
  const Surface<float> surfaces[] = {
      chosenSphereSurface(scene, ray, 2.0f, Sphere<float>{zero, 1.0f}),
      chosenBoxSurface(scene, ray, 2.0f, Box<float>{-one, one}),
      chosenOrientedBoxSurface(scene, ray, 2.0f, oriented),
      chosenPlaneSurface(scene, ray, 2.0f, Plane<float>{zero, Vector(0.0f, 1.0f, 0.0f)}),
      chosenTriangleSurface(scene, ray, 2.0f, triangle)};
  for (const Surface<float>& surface : surfaces) {
    CHECK(surface.offset == kReportOffset);
    CHECK(surface.position.y == 1.0f);
  }
}

TEST_CASE("orientedBoxSurface lies on the slab of a box with skewed and long axes") {
  const FlushDenormals flush;
  const OrientedBox<float> box{Vector(1.0f, 2.0f, 3.0f), Vector(2.0f, 0.0f, 0.0f),
                               Vector(1.0f, 3.0f, 0.0f), Vector(0.0f, 0.0f, 0.5f),
                               Vector(2.0f, 3.0f, 0.5f)};
  const Ray<float> ray = rayFrom(Vector(1.0f, 9.0f, 3.0f), Vector(0.0f, -1.0f, 0.0f));
  const float t = intersectOriented(ray, box);
  const Surface<float> surface = orientedBoxSurface(ray, t, box);
  CHECK(dot3(box.axisY, surface.position - box.center) == Approx(3.0).epsilon(1e-6));
}

TEST_CASE("intersectTriangleRobust leaves no gap along a common edge") {
  const FlushDenormals flush;
  Draw draw;
  int lost = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vector a = draw.unit();
    const Vector b = draw.unit();
    const Vector edge = b - a;
    const Vector aside = cross3(edge, draw.unit());
    const Triangle<float> one{a, b, a + edge * 0.5f + aside};
    const Triangle<float> other{b, a, a + edge * 0.5f - aside};
    const Vector direction = draw.unit();
    const Vector target = a + edge * draw.size(0.01, 0.99);
    const Ray<float> ray = rayFrom(target - direction * draw.size(1.0, 10.0), direction);
    const float t = least(intersectTriangleRobust(ray, one), intersectTriangleRobust(ray, other));
    // In a plane with the ray the two are a line to it.
    const float facing = std::fabs(dot3(normalize3(aside), cross3(normalize3(edge), direction)));
    lost += t > kLargest && facing > 1e-3f ? 1 : 0;
  }
  CHECK(lost == 0);
}

TEST_CASE("intersectTriangleRobust knows the side of an edge that float products lose") {
  const FlushDenormals flush;
  // The edge function of b and c at the ray is 2^-46: (1 + 2^-23)^2 less 1 + 2^-22.
  const Vector b(1.0f + 0x1p-23f, 1.0f, 1.0f);
  const Vector c(-1.0f - 0x1p-22f, -1.0f - 0x1p-23f, 1.0f);
  const Ray<float> ray = rayFrom(Vector(), Vector(0.0f, 0.0f, 1.0f));
  CHECK(intersectTriangleRobust(ray, {Vector(1.0f, -1.0f, 1.0f), b, c}) == kInfinity);
  CHECK(intersectTriangleRobust(ray, {Vector(-1.0f, 1.0f, 1.0f), b, c}) == 1.0f);
}

TEST_CASE("intersectTriangleReport misses what is small, intersectTriangleRobust does not") {
  const FlushDenormals flush;
  const Triangle<float> triangle{Vector(-1e-5f, -1e-5f, 0.0f), Vector(1e-5f, -1e-5f, 0.0f),
                                 Vector(0.0f, 1e-5f, 0.0f)};
  const Ray<float> ray = rayFrom(Vector(0.0f, 0.0f, -1e-5f), Vector(0.0f, 0.0f, 1.0f));
  CHECK(intersectTriangleReport(ray, triangle) == kInfinity);
  CHECK(intersectTriangleRobust(ray, triangle) == 1e-5f);
}

TEST_CASE("a ray that leaves a surface does not meet it again, at any scale and offset") {
  const FlushDenormals flush;
  for (const auto& [scale, offset] : kCells) {
    const auto size = static_cast<float>(scale);
    CAPTURE(scale, offset);
    CHECK(selfHits<Sphere<float>>(
              scale, offset,
              [&](Draw& draw, Vector center) {
                return Sphere<float>{center, size * draw.size(0.3, 1.0)};
              },
              intersectSphereRobust<float>, sphereSurface<float>) == 0);
    CHECK(selfHits<Box<float>>(
              scale, offset,
              [&](Draw& draw, Vector center) {
                const Vector half(size * draw.size(0.1, 1.0), size * draw.size(0.1, 1.0),
                                  size * draw.size(0.1, 1.0));
                return Box<float>{center - half, center + half};
              },
              intersectBoxRobust<float>, boxSurface<float>) == 0);
    CHECK(selfHits<OrientedBox<float>>(
              scale, offset, [&](Draw& draw, Vector center) { return rotatedBox(draw, center, size); },
              intersectOriented, orientedBoxSurface<float>) == 0);
    CHECK(selfHits<Plane<float>>(
              scale, offset,
              [](Draw& draw, Vector center) { return Plane<float>{center, draw.unit()}; },
              intersectPlaneRobust<float>, planeSurface<float>) == 0);
    CHECK(selfHits<Triangle<float>>(
              scale, offset,
              [&](Draw& draw, Vector center) {
                return Triangle<float>{center + draw.unit() * size, center + draw.unit() * size,
                                       center + draw.unit() * size};
              },
              intersectTriangleRobust<float>, triangleSurface<float>) == 0);
  }
}

TEST_CASE("a ray that leaves a surface stays below a plate at a millionth of the scale") {
  const FlushDenormals flush;
  const Ray<float> ray = rayFrom(Vector(0.1f, 3.0f, 0.2f), Vector(0.0f, -1.0f, 0.0f));
  const Sphere<float> sphere{Vector(0.0f, 0.0f, 0.0f), 1.0f};
  const Box<float> box{Vector(-1.0f, -1.0f, -1.0f), Vector(1.0f, 1.0f, 1.0f)};
  const Plane<float> plane{Vector(1.0f, 0.0f, 0.0f), Vector(0.0f, 1.0f, 0.0f)};
  const Triangle<float> triangle{Vector(-1.0f, 0.0f, -1.0f), Vector(1.0f, 0.0f, -1.0f),
                                 Vector(0.0f, 0.0f, 1.0f)};
  CHECK(staysBelow(sphereSurface(ray, intersectSphereRobust(ray, sphere), sphere), 1e-6));
  CHECK(staysBelow(boxSurface(ray, intersectBoxRobust(ray, box), box), 1e-6));
  const OrientedBox<float> oriented{Vector(0.0f), Vector(0.8f, 0.6f, 0.0f),
                                    Vector(-0.6f, 0.8f, 0.0f), Vector(0.0f, 0.0f, 1.0f),
                                    Vector(0.5f, 0.5f, 0.5f)};
  CHECK(staysBelow(orientedBoxSurface(ray, intersectOriented(ray, oriented), oriented), 1e-6));
  CHECK(staysBelow(planeSurface(ray, intersectPlaneRobust(ray, plane), plane), 1e-6));
  CHECK(staysBelow(triangleSurface(ray, intersectTriangleRobust(ray, triangle), triangle), 1e-6));
}

TEST_CASE("no finite ray gets a NaN") {
  const FlushDenormals flush;
  const Vector point(0.75f, -0.0f, 1.0f);
  const Sphere<float> spheres[] = {{point, 1.0f}, {point, 0.0f}, {Vector(), 3e38f}, {point, 1e-30f}};
  const Box<float> boxes[] = {{-point, point}, {point, point}, {Vector(-3e38f), Vector(3e38f)}};
  const Plane<float> planes[] = {{point, Vector(0.0f, 1.0f, 0.0f)}, {point, Vector()},
                                 {Vector(3e38f), Vector(1.0f)}};
  const Triangle<float> triangles[] = {{point, -point, Vector(0.0f, 1.0f, 0.0f)},
                                       {point, point, point},
                                       {Vector(3e38f), Vector(-3e38f), point}};
  long nanCount = 0;
  long badNormals = 0;
  const auto judge = [&](float t, const auto& surface) {
    nanCount += std::isnan(t) ? 1 : 0;
    if (t <= kLargest) badNormals += isNumber(surface()) ? 0 : 1;
  };
  forSpecialVectors([&](Vector origin) {
    forSpecialVectors([&](Vector direction) {
      // The precondition of the intersections.
      const float largest = largestCoordinate(direction);
      if (largest > 1.0f || largest < 0.5f) return;
      const Ray<float> ray = rayFrom(origin, direction);
      for (const auto& p : spheres) {
        const float t = intersectSphereRobust(ray, p);
        judge(t, [&] { return sphereSurface(ray, t, p); });
      }
      for (const auto& p : boxes) {
        const float t = intersectBoxRobust(ray, p);
        judge(t, [&] { return boxSurface(ray, t, p); });
      }
      for (const auto& p : planes) {
        const float t = intersectPlaneRobust(ray, p);
        judge(t, [&] { return planeSurface(ray, t, p); });
      }
      for (const auto& p : triangles) {
        const float t = intersectTriangleRobust(ray, p);
        judge(t, [&] { return triangleSurface(ray, t, p); });
      }
    });
  });
  CHECK(nanCount == 0);
  CHECK(badNormals == 0);
}

}  // namespace twintrace::kernel
