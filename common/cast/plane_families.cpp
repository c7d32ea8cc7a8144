// Planes: what fixed epsilons on n.d and on t get wrong, and what cancels.

#include <glm/geometric.hpp>

#include "common/cast/family_recipe.h"

namespace twintrace {
namespace {

using Draw = std::function<void(CaseRandom&, Case&)>;

struct Plane {
  glm::dvec3 normal{0.0};
  glm::dvec3 point{0.0};
};

/// The plane as rounded to float; its normal is unit to rounding.
Plane place(Case& drawn, const glm::dvec3& normal, const glm::dvec3& point) {
  const CasePrimitive primitive = planeOf(normal, point);
  drawn.primitives = {primitive};
  return {glm::dvec3(primitive.vector(0)), glm::dvec3(primitive.vector(3))};
}

Draw generic(double scale, double offset) {
  return [=](CaseRandom& random, Case& drawn) {
    const glm::dvec3 corner(offset);
    const glm::dvec3 normal = random.direction();
    place(drawn, normal, corner + random.inCube(10.0 * scale));
    const glm::dvec3 origin = corner + random.inCube(10.0 * scale);
    drawn.ray = rayOf(origin, random.direction());
  };
}

/// The angle between ray and plane has a sine of low to high.
Draw inclined(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    const glm::dvec3 normal = random.direction();
    const Plane plane = place(drawn, normal, random.inCube(10.0));
    const double sine = random.sign() * random.logarithmic(low, high);
    const glm::dvec3 origin = plane.point + random.inCube(10.0);
    drawn.ray = rayOf(origin, random.perpendicular(plane.normal) + sine * plane.normal);
  };
}

void drawAxisParallel(CaseRandom& random, Case& drawn) {
  const int axis = random.integer(0, 2);
  glm::dvec3 normal(0.0);
  normal[axis] = random.sign();
  const Plane plane = place(drawn, normal, random.inCube(10.0));
  glm::dvec3 direction = random.direction();
  const double slope = random.chance(0.2) ? 0.0 : random.uniform(0.0, 1e-7);
  direction[axis] = random.sign() * slope;
  drawn.ray = rayOf(plane.point + random.inCube(10.0), direction);
}

void drawHeight(CaseRandom& random, Case& drawn) {
  const glm::dvec3 normal = random.direction();
  const Plane plane = place(drawn, normal, random.inCube(10.0));
  const double height = random.logarithmic(1e2, 1e7);
  drawn.ray = rayOf(plane.point + plane.normal * height + random.inCube(10.0), random.direction());
}

Draw directed(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    generic(1.0, 0.0)(random, drawn);
    const glm::dvec3 d(drawn.ray.direction);
    drawn.ray.direction = glm::vec3(d * random.logarithmic(low, high));
  };
}

void drawFarT(CaseRandom& random, Case& drawn) {
  const glm::dvec3 normal = random.direction();
  const Plane plane = place(drawn, normal, random.inCube(10.0));
  const double height = random.logarithmic(1e18, 1e38);
  drawn.ray = rayOf(plane.point + plane.normal * height, random.direction());
}

void drawOn(CaseRandom& random, Case& drawn) {
  const glm::dvec3 normal = random.direction();
  const Plane plane = place(drawn, normal, random.inCube(10.0));
  const glm::dvec3 origin = plane.point + random.perpendicular(plane.normal) * 10.0;
  drawn.ray = rayOf(origin, random.direction());
}

void drawLongNormal(CaseRandom& random, Case& drawn) {
  const glm::dvec3 normal = random.direction() * random.logarithmic(1e-3, 1e3);
  place(drawn, normal, random.inCube(10.0));
  drawn.ray = rayOf(random.inCube(10.0), random.direction());
}

FamilyRecipe planeRecipe(const char* name, const char* what, Draw draw) {
  return {{name, what, FamilyKind::plane}, std::move(draw), {}};
}

}  // namespace

std::vector<FamilyRecipe> planeFamilies() {
  return {
      planeRecipe("plane-generic", "any ray, within 10", generic(1.0, 0.0)),
      planeRecipe("plane-parallel", "sine of the angle up to 1e-7, any normal",
                  inclined(1e-10, 1e-7)),
      planeRecipe("plane-axis-parallel", "the same along the axes, exact zeros among them",
                  drawAxisParallel),
      planeRecipe("plane-grazing", "sine of the angle 1e-6 to 1e-4", inclined(1e-6, 1e-4)),
      planeRecipe("plane-height", "height 1e2 to 1e7", drawHeight),
      planeRecipe("plane-translated", "moved by 1e6 along each axis", generic(1.0, 1e6)),
      planeRecipe("plane-small", "the usual scene times 1e-5", generic(1e-5, 0.0)),
      planeRecipe("plane-direction", "|direction| 1e-6 to 1e6", directed(1e-6, 1e6)),
      planeRecipe("plane-direction-long", "|direction| 1e15 to 1e37", directed(1e15, 1e37)),
      planeRecipe("plane-direction-short", "|direction| 1e-37 to 1e-15", directed(1e-37, 1e-15)),
      planeRecipe("plane-far-t", "height 1e18 to 1e38", drawFarT),
      planeRecipe("plane-on", "origin on the plane, rounded", drawOn),
      planeRecipe("plane-long-normal", "|normal| 1e-3 to 1e3", drawLongNormal),
  };
}

}  // namespace twintrace
