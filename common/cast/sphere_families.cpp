// Spheres: facts of Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray
// Tracing Gems (2019), ch. 7, pushed to where float forms fail.

#include <algorithm>
#include <cmath>

#include "common/cast/family_recipe.h"

namespace twintrace {
namespace {

using Draw = std::function<void(CaseRandom&, Case&)>;

constexpr double kUlp = 0x1p-23;  // relative to a power of two

struct Sphere {
  glm::dvec3 centre{0.0};
  double radius = 1.0;
};

Sphere usualSphere(CaseRandom& random) {
  return {random.inCube(10.0), random.logarithmic(0.1, 10.0)};
}

/// The sphere as rounded to float, so that rays can be aimed at what engines see.
Sphere place(Case& drawn, const Sphere& sphere) {
  const CasePrimitive primitive = sphereOf(sphere.centre, sphere.radius);
  drawn.primitives = {primitive};
  return {glm::dvec3(primitive.vector(0)), primitive.values[3]};
}

/// A ray that passes the centre at a distance `impact`, from `distance` before that point.
void aim(CaseRandom& random, Case& drawn, const Sphere& sphere, double distance, double impact) {
  const glm::dvec3 u = random.direction();
  const glm::dvec3 nearest = sphere.centre + random.perpendicular(u) * impact;
  drawn.ray = rayOf(nearest - u * distance, u);
}

Draw aimed(double (*impactOfRadius)(CaseRandom&)) {
  return [=](CaseRandom& random, Case& drawn) {
    const Sphere sphere = place(drawn, usualSphere(random));
    const double impact = sphere.radius * impactOfRadius(random);
    aim(random, drawn, sphere, sphere.radius * random.uniform(2.0, 20.0), impact);
  };
}

double anyImpact(CaseRandom& random) {
  return random.uniform(0.0, 2.0);
}

double tangentImpact(CaseRandom& random) {
  return 1.0 + random.uniform(-16.0, 16.0) * kUlp;
}

double grazingImpact(CaseRandom& random) {
  return 1.0 + random.sign() * random.logarithmic(1.0, 4096.0) * kUlp;
}

/// Numbers that float arithmetic holds exactly: the ray touches the sphere in one point.
void drawTangentExactly(CaseRandom& random, Case& drawn) {
  const auto eighths = [&] { return random.integer(-64, 64) / 8.0; };
  const double x = eighths();
  const double y = eighths();
  const Sphere sphere = place(drawn, {{x, y, eighths()}, random.integer(1, 64) / 8.0});
  const int along = random.integer(0, 2);
  const int aside = (along + random.integer(1, 2)) % 3;
  glm::dvec3 origin = sphere.centre;
  glm::dvec3 direction(0.0);
  direction[along] = random.sign();
  origin[aside] += random.sign() * sphere.radius;
  origin[along] -= direction[along] * random.integer(16, 128) / 8.0;
  drawn.ray = rayOf(origin, direction);
}

Draw far(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    const Sphere sphere = place(drawn, usualSphere(random));
    const double impact = sphere.radius * anyImpact(random);
    aim(random, drawn, sphere, sphere.radius * random.logarithmic(low, high), impact);
  };
}

/// The sphere's surface passes near the world's origin, where the ray starts above it.
Draw huge(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    const glm::dvec3 up = random.direction();
    const double radius = random.logarithmic(low, high);
    place(drawn, {-up * radius, radius});
    const glm::dvec3 start = up * random.logarithmic(0.01, 100.0) + random.inBall();
    drawn.ray = rayOf(start, random.direction());
  };
}

void drawTiny(CaseRandom& random, Case& drawn) {
  const Sphere sphere = place(drawn, {random.inCube(1.0), random.logarithmic(1e-7, 1e-3)});
  const double impact = sphere.radius * anyImpact(random);
  aim(random, drawn, sphere, random.uniform(1.0, 10.0), impact);
}

void drawOnSurface(CaseRandom& random, Case& drawn) {
  const Sphere sphere = place(drawn, usualSphere(random));
  const double height = 1.0 + random.integer(-4, 4) * kUlp;
  const glm::dvec3 start = sphere.centre + random.direction() * (sphere.radius * height);
  drawn.ray = rayOf(start, random.direction());
}

void drawInside(CaseRandom& random, Case& drawn) {
  const Sphere sphere = place(drawn, usualSphere(random));
  const glm::dvec3 start = sphere.centre + random.inBall() * (0.99 * sphere.radius);
  drawn.ray = rayOf(start, random.direction());
}

void drawTranslated(CaseRandom& random, Case& drawn) {
  Sphere wish = usualSphere(random);
  wish.centre += glm::dvec3(random.sign(), random.sign(), random.sign()) * 1e6;
  const Sphere sphere = place(drawn, wish);
  const double impact = sphere.radius * anyImpact(random);
  aim(random, drawn, sphere, sphere.radius * random.uniform(2.0, 20.0), impact);
}

Draw directed(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    aimed(anyImpact)(random, drawn);
    const glm::dvec3 d(drawn.ray.direction);
    drawn.ray.direction = glm::vec3(d * random.logarithmic(low, high));
  };
}

void drawFarT(CaseRandom& random, Case& drawn) {
  const double distance = random.logarithmic(1e18, 1e38);
  const Sphere sphere = place(drawn, {glm::dvec3(0.0), distance * random.uniform(0.05, 0.5)});
  const double impact = sphere.radius * anyImpact(random);
  aim(random, drawn, sphere, distance, impact);
}

/// One end of the interval lies within 4 ulp of the entry's or the exit's t.
void drawInterval(CaseRandom& random, Case& drawn) {
  const Sphere sphere = place(drawn, usualSphere(random));
  const double impact = sphere.radius * random.uniform(0.0, 0.9);
  const double distance = sphere.radius * random.uniform(2.0, 20.0);
  aim(random, drawn, sphere, distance, impact);
  const double chord = std::sqrt(sphere.radius * sphere.radius - impact * impact);
  const double t = distance + random.sign() * chord;
  const auto end = static_cast<float>(t * (1.0 + random.integer(-4, 4) * kUlp));
  (random.chance(0.5) ? drawn.ray.tmin : drawn.ray.tmax) = end;
}

FamilyRecipe sphereRecipe(const char* name, const char* what, Draw draw) {
  return {{name, what, FamilyKind::sphere}, std::move(draw), {}};
}

}  // namespace

std::vector<FamilyRecipe> sphereFamilies() {
  return {
      sphereRecipe("sphere-generic", "passes within 2 radii, from 2 to 20 radii", aimed(anyImpact)),
      sphereRecipe("sphere-inside", "origin within 0.99 radii", drawInside),
      sphereRecipe("sphere-tangent", "tangent within 16 ulp of the radius", aimed(tangentImpact)),
      sphereRecipe("sphere-tangent-exact", "exactly tangent, in numbers that floats hold",
                   drawTangentExactly),
      sphereRecipe("sphere-grazing", "tangent within 2^0 to 2^12 ulp", aimed(grazingImpact)),
      sphereRecipe("sphere-far-1e3", "distance / radius 1e2 to 1e3", far(1e2, 1e3)),
      sphereRecipe("sphere-far-1e4", "distance / radius 1e3 to 1e4", far(1e3, 1e4)),
      sphereRecipe("sphere-far-1e5", "distance / radius 1e4 to 1e5", far(1e4, 1e5)),
      sphereRecipe("sphere-far-1e6", "distance / radius 1e5 to 1e6", far(1e5, 1e6)),
      sphereRecipe("sphere-far-1e7", "distance / radius 1e6 to 1e7", far(1e6, 1e7)),
      sphereRecipe("sphere-huge-1e4", "radius 1e3 to 1e4, from 0.01 to 100 above", huge(1e3, 1e4)),
      sphereRecipe("sphere-huge-1e6", "radius 1e5 to 1e6, from 0.01 to 100 above", huge(1e5, 1e6)),
      sphereRecipe("sphere-huge-1e8", "radius 1e7 to 1e8, from 0.01 to 100 above", huge(1e7, 1e8)),
      sphereRecipe("sphere-tiny", "radius 1e-7 to 1e-3 at distance 1 to 10", drawTiny),
      sphereRecipe("sphere-on-surface", "origin on the surface within 4 ulp", drawOnSurface),
      sphereRecipe("sphere-translated", "usual scene moved by 1e6 along each axis", drawTranslated),
      sphereRecipe("sphere-direction", "|direction| 1e-6 to 1e6", directed(1e-6, 1e6)),
      sphereRecipe("sphere-direction-long", "|direction| 1e15 to 1e37", directed(1e15, 1e37)),
      sphereRecipe("sphere-direction-short", "|direction| 1e-37 to 1e-15", directed(1e-37, 1e-15)),
      sphereRecipe("sphere-far-t", "hits at t of 1e18 to 1.5e38", drawFarT),
      sphereRecipe("sphere-interval", "an end of the interval within 4 ulp of a hit", drawInterval),
  };
}

}  // namespace twintrace
