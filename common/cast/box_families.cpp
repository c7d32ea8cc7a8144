// Boxes, and the same boxes turned by a rotation matrix in float.

#include <cmath>
#include <utility>

#include "common/cast/family_recipe.h"

namespace twintrace {
namespace {

using Draw = std::function<void(CaseRandom&, Case&)>;

struct Box {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};

  glm::dvec3 centre() const { return 0.5 * (low + high); }
  glm::dvec3 size() const { return high - low; }
};

/// The box as rounded to float.
Box place(Case& drawn, const Box& box) {
  const CasePrimitive primitive = boxOf(box.low, box.high);
  drawn.primitives = {primitive};
  return {glm::dvec3(primitive.vector(0)), glm::dvec3(primitive.vector(3))};
}

glm::dvec3 usualSize(CaseRandom& random) {
  const double x = random.logarithmic(0.1, 10.0);
  const double y = random.logarithmic(0.1, 10.0);
  return {x, y, random.logarithmic(0.1, 10.0)};
}

Box boxAround(const glm::dvec3& centre, const glm::dvec3& size) {
  return {centre - 0.5 * size, centre + 0.5 * size};
}

Box usualBox(CaseRandom& random) {
  const glm::dvec3 centre = random.inCube(10.0);
  return boxAround(centre, usualSize(random));
}

double largest(const glm::dvec3& v) {
  return std::fmax(v.x, std::fmax(v.y, v.z));
}

/// A point of the box grown to 1.5 of its size.
glm::dvec3 targetNear(CaseRandom& random, const Box& box) {
  return box.centre() + random.inCube(0.75) * box.size();
}

void aim(CaseRandom& random, Case& drawn, const Box& box, double distance) {
  const glm::dvec3 target = targetNear(random, box);
  drawn.ray = rayTowards(target + random.direction() * distance, target);
}

void aimFromUsualDistance(CaseRandom& random, Case& drawn, const Box& box) {
  aim(random, drawn, box, largest(box.size()) * random.uniform(2.0, 10.0));
}

void drawGeneric(CaseRandom& random, Case& drawn) {
  aimFromUsualDistance(random, drawn, place(drawn, usualBox(random)));
}

void drawInside(CaseRandom& random, Case& drawn) {
  const Box box = place(drawn, usualBox(random));
  drawn.ray = rayOf(box.centre() + random.inCube(0.49) * box.size(), random.direction());
}

double signedZero(CaseRandom& random) {
  return random.chance(0.5) ? 0.0 : -0.0;
}

/// Runs along an axis, in the plane of a face or two: on a face or an edge.
void drawAxisInFace(CaseRandom& random, Case& drawn) {
  const Box box = place(drawn, usualBox(random));
  const int along = random.integer(0, 2);
  const int first = (along + random.integer(1, 2)) % 3;
  const int second = 3 - along - first;
  glm::dvec3 direction(signedZero(random), signedZero(random), signedZero(random));
  direction[along] = random.sign();
  glm::dvec3 origin = box.centre() + random.inCube(0.49) * box.size();
  origin[first] = random.chance(0.5) ? box.low[first] : box.high[first];
  if (random.chance(0.5)) origin[second] = random.chance(0.5) ? box.low[second] : box.high[second];
  origin[along] -= direction[along] * box.size()[along] * random.uniform(1.0, 4.0);
  drawn.ray = rayOf(origin, direction);
}

/// A point on a random edge, or a corner.
glm::dvec3 pointOnEdge(CaseRandom& random, const Box& box, double along) {
  const int free = random.chance(0.5) ? random.integer(0, 2) : -1;
  glm::dvec3 point(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const bool atHigh = axis == free ? false : random.chance(0.5);
    point[axis] = atHigh ? box.high[axis] : box.low[axis];
    if (axis == free) point[axis] += along * box.size()[axis];
  }
  return point;
}

/// Multiples of 1/8 below 2^8: sums and differences of them are exact in float.
void drawCornerExactly(CaseRandom& random, Case& drawn) {
  const auto eighths = [&](int low, int high) { return random.integer(low, high) / 8.0; };
  const auto vector = [&](int low, int high) {
    const double x = eighths(low, high);
    const double y = eighths(low, high);
    return glm::dvec3(x, y, eighths(low, high));
  };
  const glm::dvec3 low = vector(-64, 64);
  const Box box = place(drawn, {low, low + 8.0 * vector(1, 16)});
  const glm::dvec3 target = pointOnEdge(random, box, random.integer(1, 7) / 8.0);
  const glm::dvec3 direction = vector(-32, 32) + glm::dvec3(0.0, 0.0, 16.0);
  drawn.ray = rayOf(target - direction * double(random.integer(1, 4)), direction);
}

void drawEdge(CaseRandom& random, Case& drawn) {
  const Box box = place(drawn, usualBox(random));
  const glm::dvec3 target = pointOnEdge(random, box, random.uniform());
  const double distance = largest(box.size()) * random.uniform(2.0, 10.0);
  drawn.ray = rayTowards(target + random.direction() * distance, target);
}

/// Each component is a zero, a denormal or usual; at least one is usual.
void drawSignedZero(CaseRandom& random, Case& drawn) {
  const Box box = place(drawn, usualBox(random));
  const glm::dvec3 usual = random.direction();
  const int kept = random.integer(0, 2);
  glm::dvec3 direction = usual;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == kept || random.chance(0.3)) continue;
    direction[axis] = random.chance(0.5) ? signedZero(random) : random.sign() * 1e-40;
  }
  glm::dvec3 target = targetNear(random, box);
  for (int axis = 0; axis < 3; ++axis) {
    if (random.chance(0.3)) target[axis] = random.chance(0.5) ? box.low[axis] : box.high[axis];
  }
  drawn.ray =
      rayOf(target - direction * (largest(box.size()) * random.uniform(0.0, 5.0)), direction);
}

Box flatBox(CaseRandom& random, int axis) {
  Box box = usualBox(random);
  box.high[axis] = box.low[axis];
  return box;
}

void drawFlat(CaseRandom& random, Case& drawn) {
  aimFromUsualDistance(random, drawn, place(drawn, flatBox(random, random.integer(0, 2))));
}

void drawFlatInPlane(CaseRandom& random, Case& drawn) {
  const int axis = random.integer(0, 2);
  const Box box = place(drawn, flatBox(random, axis));
  aimFromUsualDistance(random, drawn, box);
  drawn.ray.origin[axis] = static_cast<float>(box.low[axis]);
  drawn.ray.direction[axis] = static_cast<float>(signedZero(random));
}

void drawThin(CaseRandom& random, Case& drawn) {
  const glm::dvec3 centre = random.inCube(1.0);
  glm::dvec3 size = usualSize(random);
  size[random.integer(0, 2)] *= 1e-6;
  aimFromUsualDistance(random, drawn, place(drawn, boxAround(centre, size)));
}

void drawTranslated(CaseRandom& random, Case& drawn) {
  const glm::dvec3 offset(random.sign() * 1e6, random.sign() * 1e6, random.sign() * 1e6);
  const glm::dvec3 size = 10.0 * usualSize(random);
  aimFromUsualDistance(random, drawn, place(drawn, boxAround(offset + random.inCube(10.0), size)));
}

Draw far(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    const Box box = place(drawn, usualBox(random));
    aim(random, drawn, box, largest(box.size()) * random.logarithmic(low, high));
  };
}

Draw directed(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    drawGeneric(random, drawn);
    const glm::dvec3 d(drawn.ray.direction);
    drawn.ray.direction = glm::vec3(d * random.logarithmic(low, high));
  };
}

Draw scaled(double scale) {
  return [=](CaseRandom& random, Case& drawn) {
    const Box usual = usualBox(random);
    aimFromUsualDistance(random, drawn, place(drawn, {usual.low * scale, usual.high * scale}));
  };
}

void drawFarT(CaseRandom& random, Case& drawn) {
  const double distance = random.logarithmic(1e18, 1e38);
  const glm::dvec3 size = glm::dvec3(distance * random.uniform(0.05, 0.5));
  aim(random, drawn, place(drawn, boxAround(glm::dvec3(0.0), size)), distance);
}

void drawOnFace(CaseRandom& random, Case& drawn) {
  const Box box = place(drawn, usualBox(random));
  glm::dvec3 origin = box.centre() + random.inCube(0.49) * box.size();
  const int axis = random.integer(0, 2);
  origin[axis] = random.chance(0.5) ? box.low[axis] : box.high[axis];
  drawn.ray = rayOf(origin, random.direction());
}

/// Runs along a face, at a height and with a slope of 1e-7.
void drawGrazing(CaseRandom& random, Case& drawn) {
  const Box box = place(drawn, boxAround(glm::dvec3(0.0), usualSize(random)));
  const int axis = random.integer(0, 2);
  const int along = (axis + random.integer(1, 2)) % 3;
  const double side = random.sign();
  glm::dvec3 origin = random.inCube(0.49) * box.size();
  origin[axis] = side * (0.5 * box.size()[axis] + random.uniform(-1e-7, 1e-7));
  origin[along] = -2.0 * box.size()[along];
  glm::dvec3 direction(0.0);
  direction[along] = 1.0;
  direction[axis] = random.uniform(-1e-7, 1e-7);
  drawn.ray = rayOf(origin, direction);
}

/// Of turned boxes some keep their axes along the world's, in another order and with other signs,
/// so that exact coincidences survive.
glm::dmat3 quarterTurn(CaseRandom& random) {
  const int first = random.integer(0, 2);
  const int second = (first + random.integer(1, 2)) % 3;
  glm::dmat3 axes(0.0);
  axes[0][first] = random.sign();
  axes[1][second] = random.sign();
  axes[2][3 - first - second] = random.sign();
  return axes;
}

Draw turned(Draw drawBox) {
  return [draw = std::move(drawBox)](CaseRandom& random, Case& drawn) {
    draw(random, drawn);
    const glm::dmat3 axes = random.chance(0.25) ? quarterTurn(random) : random.rotation();
    drawn = moved(drawn, axes, glm::dvec3(0.0));
  };
}

struct BoxFamily {
  const char* name;  ///< without its prefix
  const char* what;
  Draw draw;
};

std::vector<BoxFamily> allBoxes() {
  return {
      {"generic", "aimed at the box or near it, from 2 to 10 sizes", drawGeneric},
      {"inside", "origin inside", drawInside},
      {"axis-in-face", "along an axis, in a face or an edge, zeros of both signs", drawAxisInFace},
      {"corner-exact", "through an edge or corner, in numbers that floats hold", drawCornerExactly},
      {"edge", "aimed at an edge or corner", drawEdge},
      {"signed-zero", "direction components +-0 or denormal, origins in face planes",
       drawSignedZero},
      {"flat", "no thickness", drawFlat},
      {"flat-in-plane", "no thickness, the ray in its plane", drawFlatInPlane},
      {"thin-1e6", "one side 1e6 times shorter", drawThin},
      {"translated", "size 1 to 100, moved by 1e6 along each axis", drawTranslated},
      {"far-1e6", "distance / size 1e4 to 1e6", far(1e4, 1e6)},
      {"far-1e8", "distance / size 1e6 to 1e8", far(1e6, 1e8)},
      {"direction", "|direction| 1e-6 to 1e6", directed(1e-6, 1e6)},
      {"direction-long", "|direction| 1e15 to 1e37", directed(1e15, 1e37)},
      {"direction-short", "|direction| 1e-38 to 1e-15", directed(1e-38, 1e-15)},
      {"far-t", "hits at t of 1e18 to 3e38", drawFarT},
      {"on-face", "origin on a face", drawOnFace},
      {"grazing", "along a face, height and slope within 1e-7", drawGrazing},
      {"small", "the usual scene times 1e-5", scaled(1e-5)},
      {"large", "the usual scene times 1e4", scaled(1e4)},
  };
}

}  // namespace

std::vector<FamilyRecipe> boxFamilies() {
  std::vector<FamilyRecipe> recipes;
  for (const BoxFamily& family : allBoxes()) {
    recipes.push_back(
        {{std::string("box-") + family.name, family.what, FamilyKind::box}, family.draw, {}});
  }
  return recipes;
}

std::vector<FamilyRecipe> orientedFamilies() {
  std::vector<FamilyRecipe> recipes;
  for (const BoxFamily& family : allBoxes()) {
    const std::string what = std::string("turned: ") + family.what;
    recipes.push_back({{std::string("oriented-") + family.name, what, FamilyKind::orientedBox},
                       turned(family.draw),
                       {}});
  }
  return recipes;
}

}  // namespace twintrace
