// Scenes of several primitives: the closest one wins, the first of equals.

#include <utility>

#include "common/cast/family_recipe.h"

namespace twintrace {
namespace {

using Draw = std::function<void(CaseRandom&, Case&)>;

CasePrimitive anyPrimitive(CaseRandom& random, const glm::dvec3& offset) {
  const glm::dvec3 at = offset + random.inCube(4.0);
  const glm::dvec3 size = glm::dvec3(0.2) + 0.9 * (random.inCube(1.0) + glm::dvec3(1.0));
  switch (random.integer(0, 4)) {
    case 0:
      return sphereOf(at, size.x);
    case 1:
      return boxOf(at - size, at + size);
    case 2:
      return orientedBoxOf(at, random.rotation(), size);
    case 3:
      return planeOf(random.direction(), at);
    default: {
      const glm::dvec3 b = at + 2.0 * random.inBall();
      return triangleOf(at, b, at + 2.0 * random.inBall());
    }
  }
}

Draw mixed(double offset) {
  return [=](CaseRandom& random, Case& drawn) {
    const glm::dvec3 corner(offset);
    const int count = random.integer(2, 8);
    for (int i = 0; i < count; ++i) drawn.primitives.push_back(anyPrimitive(random, corner));
    const glm::dvec3 target = corner + random.inCube(4.0);
    drawn.ray = rayTowards(corner + 8.0 * random.direction(), target);
  };
}

/// Boxes, planes and triangles that share the plane y = height, in numbers that floats hold.
CasePrimitive withFaceAt(CaseRandom& random, double height) {
  const double x = random.integer(-16, 16) / 8.0;
  const double z = random.integer(-16, 16) / 8.0;
  switch (random.integer(0, 3)) {
    case 0:
      return boxOf({x - 2.0, height - 1.0, z - 2.0}, {x + 2.0, height, z + 2.0});
    case 1:
      return planeOf({0.0, 1.0, 0.0}, {x, height, z});
    case 2:
      return triangleOf({x - 4.0, height, z - 4.0}, {x + 4.0, height, z - 4.0},
                        {x, height, z + 4.0});
    default:
      return orientedBoxOf({x, height - 0.5, z}, glm::dmat3(1.0), {2.0, 0.5, 2.0});
  }
}

void drawTies(CaseRandom& random, Case& drawn) {
  const double height = random.integer(-32, 32) / 8.0;
  const int count = random.integer(2, 5);
  for (int i = 0; i < count; ++i) drawn.primitives.push_back(withFaceAt(random, height));
  const double x = random.integer(-12, 12) / 8.0;
  const glm::dvec3 target(x, height, random.integer(-12, 12) / 8.0);
  const double dx = random.integer(-8, 8) / 8.0;
  const glm::dvec3 direction(dx, -1.0, random.integer(-8, 8) / 8.0);
  drawn.ray = rayOf(target - direction * double(1 << random.integer(0, 3)), direction);
}

/// The same primitive twice among others.
void drawTwice(CaseRandom& random, Case& drawn) {
  mixed(0.0)(random, drawn);
  const int last = static_cast<int>(drawn.primitives.size()) - 1;
  drawn.primitives.push_back(drawn.primitives[random.integer(0, last)]);
}

FamilyRecipe sceneRecipe(const char* name, const char* what, Draw draw) {
  return {{name, what, FamilyKind::scene}, std::move(draw), {}};
}

}  // namespace

std::vector<FamilyRecipe> sceneFamilies() {
  return {
      sceneRecipe("scene-mixed", "2 to 8 primitives of all kinds", mixed(0.0)),
      sceneRecipe("scene-translated", "the same, moved by 1e4 along each axis", mixed(1e4)),
      sceneRecipe("scene-twice", "one primitive twice: the first wins", drawTwice),
      sceneRecipe("scene-ties", "2 to 5 faces in one plane: the first wins", drawTies),
  };
}

}  // namespace twintrace
