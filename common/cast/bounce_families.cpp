// Bounces: a ray that leaves a surface must neither hit it again nor jump over what is close above
// it.

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "common/cast/family_recipe.h"

namespace twintrace {
namespace {

/// A surface around the world's origin whose point (0, top, 0) has the normal +y.
struct Surface {
  CasePrimitive primitive;
  double top = 0.0;
  double radius = 0.0;  ///< of its curvature, 0 where it is flat
};

Surface surfaceOf(CaseKind kind, double scale) {
  const double rounded = static_cast<float>(scale);
  const double top = 0.5 * rounded;
  const glm::dvec3 half(top);
  switch (kind) {
    case CaseKind::sphere:
      return {sphereOf(glm::dvec3(0.0), top), top, top};
    case CaseKind::box:
      return {boxOf(-half, half), top};
    case CaseKind::orientedBox:
      return {orientedBoxOf(glm::dvec3(0.0), glm::dmat3(1.0), half), top};
    case CaseKind::plane:
      return {planeOf({0.0, 1.0, 0.0}, {0.0, top, 0.0}), top};
    case CaseKind::triangle:
      break;
  }
  return {triangleOf({-top, top, -top}, {top, top, -top}, {0.0, top, top}), top};
}

/// Moves without turning, so that the box stays one.
void shiftBox(Case& drawn, const glm::dvec3& offset) {
  const auto corner = [&](int first) {
    return glm::dvec3(drawn.primitives[0].vector(first)) + offset;
  };
  drawn.primitives = {boxOf(corner(0), corner(3))};
  drawn.ray.origin = glm::vec3(glm::dvec3(drawn.ray.origin) + offset);
}

/// Both numbers stay away from 0 and 1, so that the cosine-weighted direction leaves at 5 degrees
/// above the surface or more, whichever of the two decides that.
Bounce usualBounce(CaseRandom& random) {
  const auto first = static_cast<float>(random.uniform(0.01, 0.99));
  return {first, static_cast<float>(random.uniform(0.01, 0.99))};
}

Bounce anyBounce(CaseRandom& random) {
  // Rounding to float must not reach 1.
  const auto number = [&] { return static_cast<float>(random.bits() >> 40) * 0x1p-24f; };
  const float first = number();
  return {first, number()};
}

/// Where a ray comes down on the surface, within `reach` of its top along x and z.
glm::dvec3 footOn(CaseRandom& random, const Surface& surface, double reach) {
  const double x = random.uniform(-reach, reach);
  const double z = random.uniform(-reach, reach);
  if (surface.radius == 0.0) return {x, surface.top, z};
  return {x, std::sqrt(surface.radius * surface.radius - x * x - z * z), z};
}

/// A ray from above hits the surface and leaves it again.
void drawSelfHit(CaseRandom& random, Case& drawn, CaseKind kind, double scale,
                 const glm::dvec3& offset) {
  const Surface surface = surfaceOf(kind, scale);
  drawn.primitives = {surface.primitive};
  const glm::dvec3 foot = footOn(random, surface, 0.4 * surface.top);
  const glm::dvec3 from = glm::dvec3(0.0, 1.0, 0.0) + 0.9 * random.inBall();
  drawn.ray = rayTowards(foot + from * (scale * random.uniform(1.0, 10.0)), foot);
  drawn.bounce = anyBounce(random);
  if (kind == CaseKind::box) return shiftBox(drawn, offset);
  drawn = moved(drawn, random.rotation(), offset);
}

void drawAtOrigin(CaseRandom& random, Case& drawn, CaseKind kind) {
  drawSelfHit(random, drawn, kind, random.logarithmic(1e-3, 1e6), glm::dvec3(0.0));
}

void drawOffset(CaseRandom& random, Case& drawn, CaseKind kind) {
  const double distance = random.logarithmic(1e3, 1e6);
  const double scale = distance * random.logarithmic(1e-4, 1e-3);
  const glm::dvec3 offset(random.sign(), random.sign(), random.sign());
  drawSelfHit(random, drawn, kind, scale, offset * distance);
}

/// The ray starts between the surface and the plate, and the bounce meets the plate within ten gaps
/// beside its foot.
void drawPlate(CaseRandom& random, Case& drawn, CaseKind kind) {
  const double scale = random.logarithmic(1e-3, 1e3);
  const Surface surface = surfaceOf(kind, scale);
  const double gap = scale * random.logarithmic(1e-6, 1e-2);
  const double thickness = scale * random.logarithmic(1e-6, 1e-1);
  const double low = surface.top + gap;
  const CasePrimitive plate =
      boxOf({-surface.top, low, -surface.top}, {surface.top, low + thickness, surface.top});
  drawn.primitives = {surface.primitive, plate};
  // On a sphere near the pole, where it is sunk by less than a twentieth of the gap.
  const double reach = 0.2 * std::sqrt(gap * surface.top);
  const glm::dvec3 foot = footOn(random, surface, reach);
  const double height = gap * random.uniform(0.3, 0.7);
  const glm::dvec3 aside(random.uniform(-1.0, 1.0), 0.0, random.uniform(-1.0, 1.0));
  drawn.ray = rayOf(foot + height * (glm::dvec3(0.0, 1.0, 0.0) + aside),
                    -(glm::dvec3(0.0, 1.0, 0.0) + aside));
  drawn.bounce = usualBounce(random);
  if (kind == CaseKind::orientedBox) drawn = moved(drawn, random.rotation(), glm::dvec3(0.0));
}

using DrawKind = void (*)(CaseRandom&, Case&, CaseKind);

FamilyRecipe bounceRecipe(const std::string& name, const std::string& what, Expectation expectation,
                          DrawKind draw, CaseKind kind) {
  return {{name, what, FamilyKind::bounce, expectation},
          [=](CaseRandom& random, Case& drawn) { draw(random, drawn, kind); },
          {}};
}

}  // namespace

std::vector<FamilyRecipe> bounceFamilies() {
  const std::vector<std::pair<CaseKind, std::string>> kinds = {{CaseKind::sphere, "sphere"},
                                                               {CaseKind::box, "box"},
                                                               {CaseKind::orientedBox, "oriented"},
                                                               {CaseKind::plane, "plane"},
                                                               {CaseKind::triangle, "triangle"}};
  std::vector<FamilyRecipe> recipes;
  for (const auto& [kind, name] : kinds) {
    recipes.push_back(bounceRecipe("self-hit-" + name, "bounce off it, size 1e-3 to 1e6",
                                   Expectation::escape, drawAtOrigin, kind));
    recipes.push_back(
        bounceRecipe("self-hit-" + name + "-offset",
                     "the same at 1e3 to 1e6 from the origin, size 1e-4 of that or more",
                     Expectation::escape, drawOffset, kind));
  }
  for (const auto& [kind, name] : kinds) {
    recipes.push_back(bounceRecipe("thin-plate-" + name,
                                   "bounce below a plate, gap 1e-6 to 1e-2 of the size",
                                   Expectation::plate, drawPlate, kind));
  }
  return recipes;
}

}  // namespace twintrace
