// Triangles: edges and vertices, where neighbours must leave no crack (Woop, Benthin, Wald 2013),
// and shapes that cost digits.

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "common/cast/family_recipe.h"

namespace twintrace {
namespace {

using Draw = std::function<void(CaseRandom&, Case&)>;
using Corners = std::array<glm::dvec3, 3>;

Corners cornersOf(const CasePrimitive& triangle) {
  return {glm::dvec3(triangle.vector(0)), glm::dvec3(triangle.vector(3)),
          glm::dvec3(triangle.vector(6))};
}

/// The triangle as rounded to float.
Corners place(Case& drawn, const Corners& corners) {
  drawn.primitives = {triangleOf(corners[0], corners[1], corners[2])};
  return cornersOf(drawn.primitives[0]);
}

Corners usualTriangle(CaseRandom& random) {
  const glm::dvec3 centre = random.inCube(2.0);
  const glm::dvec3 a = centre + random.inBall();
  const glm::dvec3 b = centre + random.inBall();
  return {a, b, centre + random.inBall()};
}

Corners transformed(Corners corners, double scale, const glm::dvec3& offset) {
  for (glm::dvec3& corner : corners) corner = corner * scale + offset;
  return corners;
}

double sizeOf(const Corners& c) {
  return std::fmax(glm::length(c[1] - c[0]),
                   std::fmax(glm::length(c[2] - c[0]), glm::length(c[2] - c[1])));
}

glm::dvec3 pointOf(const Corners& c, double u, double v) {
  return c[0] + (c[1] - c[0]) * u + (c[2] - c[0]) * v;
}

/// A point in the triangle's plane, about half of the time within the triangle.
glm::dvec3 pointNear(CaseRandom& random, const Corners& corners) {
  const double u = random.uniform(-0.25, 1.0);
  return pointOf(corners, u, random.uniform(-0.25, 1.0));
}

glm::dvec3 pointOnEdge(CaseRandom& random, const Corners& c) {
  const int first = random.integer(0, 2);
  const glm::dvec3& from = c[first];
  return from + (c[(first + 1) % 3] - from) * random.uniform();
}

void aimAt(CaseRandom& random, Case& drawn, const glm::dvec3& target, double distance) {
  drawn.ray = rayTowards(target + random.direction() * distance, target);
}

void aimNear(CaseRandom& random, Case& drawn, const Corners& corners) {
  const double distance = sizeOf(corners) * random.uniform(1.0, 10.0);
  aimAt(random, drawn, pointNear(random, corners), distance);
}

Draw scaled(double scale, double offset) {
  return [=](CaseRandom& random, Case& drawn) {
    const Corners wish = transformed(usualTriangle(random), scale, glm::dvec3(offset));
    aimNear(random, drawn, place(drawn, wish));
  };
}

void drawEdge(CaseRandom& random, Case& drawn) {
  const Corners corners = place(drawn, usualTriangle(random));
  aimAt(random, drawn, pointOnEdge(random, corners), random.uniform(1.0, 10.0));
}

void drawVertex(CaseRandom& random, Case& drawn) {
  const Corners corners = place(drawn, usualTriangle(random));
  aimAt(random, drawn, corners[random.integer(0, 2)], random.uniform(1.0, 10.0));
}

/// Integers: the target lies exactly on the edge, and the ray passes exactly through it.
void drawEdgeExactly(CaseRandom& random, Case& drawn) {
  const auto vector = [&](int size) {
    const double x = random.integer(-size, size);
    const double y = random.integer(-size, size);
    return glm::dvec3(x, y, random.integer(-size, size));
  };
  const glm::dvec3 a = vector(64);
  const Corners corners = place(drawn, {a, a + 8.0 * vector(16), vector(64)});
  const glm::dvec3 step = (corners[1] - corners[0]) / 8.0;
  const glm::dvec3 target = corners[0] + step * double(random.integer(0, 8));
  const glm::dvec3 direction = vector(32) + glm::dvec3(0.0, 0.0, 0.5);
  drawn.ray = rayOf(target - direction * double(2 * random.integer(1, 4)), direction);
}

/// The third corner is close to the first two's edge.
Draw sliver(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    const glm::dvec3 a = random.inCube(2.0);
    const glm::dvec3 along = random.direction() * random.uniform(0.5, 2.0);
    const double height = glm::length(along) / random.logarithmic(low, high);
    const glm::dvec3 c = a + along * random.uniform() + random.perpendicular(along) * height;
    aimNear(random, drawn, place(drawn, {a, a + along, c}));
  };
}

Draw far(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    const Corners corners = place(drawn, usualTriangle(random));
    const glm::dvec3 target = pointNear(random, corners);
    aimAt(random, drawn, target, sizeOf(corners) * random.logarithmic(low, high));
  };
}

glm::dvec3 unitNormal(const Corners& c) {
  const glm::dvec3 n = glm::cross(c[1] - c[0], c[2] - c[0]);
  return n / glm::length(n);
}

/// From a distance at an angle whose sine is low to high.
void aimGrazing(CaseRandom& random, Case& drawn, const Corners& corners, double distance,
                double sine) {
  const glm::dvec3 normal = unitNormal(corners);
  const glm::dvec3 back = random.perpendicular(normal) + random.sign() * sine * normal;
  const glm::dvec3 target = pointNear(random, corners);
  drawn.ray = rayTowards(target + back * distance, target);
}

void drawGrazing(CaseRandom& random, Case& drawn) {
  const Corners corners = place(drawn, usualTriangle(random));
  const double sine = random.logarithmic(1e-6, 1e-2);
  aimGrazing(random, drawn, corners, random.uniform(1.0, 10.0), sine);
}

/// The shape of a wrong hit that users of Embree report (its issue 387): edges about 11, 10
/// and 1.4, seen under half a degree from some 500 away.
void drawSkinnyGrazing(CaseRandom& random, Case& drawn) {
  const glm::dvec3 a = random.inCube(500.0);
  const glm::dvec3 along = random.direction();
  const glm::dvec3 aside = random.perpendicular(along);
  const double length = random.uniform(8.0, 12.0);
  const Corners corners = place(
      drawn, {a, a + along * length,
              a + along * (length * random.uniform(0.8, 1.0)) + aside * random.uniform(0.01, 2.0)});
  const double sine = random.logarithmic(1e-5, 1e-2);
  aimGrazing(random, drawn, corners, random.uniform(100.0, 600.0), sine);
}

Draw directed(double low, double high) {
  return [=](CaseRandom& random, Case& drawn) {
    scaled(1.0, 0.0)(random, drawn);
    const glm::dvec3 d(drawn.ray.direction);
    drawn.ray.direction = glm::vec3(d * random.logarithmic(low, high));
  };
}

void drawFarT(CaseRandom& random, Case& drawn) {
  const double distance = random.logarithmic(1e18, 1e37);
  const double scale = distance * random.uniform(0.05, 0.5);
  const Corners wish = transformed(usualTriangle(random), scale, glm::dvec3(0.0));
  const Corners corners = place(drawn, wish);
  aimAt(random, drawn, pointNear(random, corners), distance);
}

/// In the plane of an axis-aligned triangle: a miss by contract.
void drawInPlane(CaseRandom& random, Case& drawn) {
  const int axis = random.integer(0, 2);
  Corners wish = usualTriangle(random);
  for (glm::dvec3& corner : wish) corner[axis] = wish[0][axis];
  const Corners corners = place(drawn, wish);
  aimNear(random, drawn, corners);
  drawn.ray.origin[axis] = static_cast<float>(corners[0][axis]);
  drawn.ray.direction[axis] = random.chance(0.5) ? 0.0f : -0.0f;
}

/// Corners on one line, in numbers that floats hold: no area, a miss by contract.
void drawNoArea(CaseRandom& random, Case& drawn) {
  const auto eighths = [&] { return random.integer(-64, 64) / 8.0; };
  const double x = eighths();
  const double y = eighths();
  const glm::dvec3 a(x, y, eighths());
  const double dx = eighths();
  const double dy = eighths();
  const glm::dvec3 step(dx, dy, eighths());
  const Corners corners = place(drawn, {a, a + step, a + step * double(random.integer(-3, 3))});
  aimAt(random, drawn, pointOnEdge(random, corners), random.uniform(1.0, 10.0));
}

/// Out of a triangle's plane by an angle whose sine is at least a hundredth. In the plane a quad is a
/// line, and rounding may take the ray past all of it.
glm::dvec3 steepDirection(CaseRandom& random, const Corners& corners) {
  const glm::dvec3 normal = unitNormal(corners);
  while (true) {
    const glm::dvec3 direction = random.direction();
    if (std::abs(glm::dot(direction, normal)) >= 0.01) return direction;
  }
}

/// A quad of two triangles, seen at its diagonal.
void drawSharedEdge(CaseRandom& random, Case& drawn) {
  const Corners first = usualTriangle(random);
  const glm::dvec3 fourth = first[1] + first[2] - first[0];
  drawn.primitives = {triangleOf(first[0], first[1], first[2]),
                      triangleOf(fourth, first[2], first[1])};
  const Corners corners = cornersOf(drawn.primitives[0]);
  const double at = random.uniform(0.01, 0.99);
  const glm::dvec3 target = corners[1] + (corners[2] - corners[1]) * at;
  const glm::dvec3 back = steepDirection(random, corners);
  drawn.ray = rayTowards(target + back * random.uniform(1.0, 10.0), target);
}

/// Triangles around a vertex, seen from its side at the vertex or at an edge that two of them
/// share.
void drawFan(CaseRandom& random, Case& drawn) {
  const glm::dvec3 apex = random.inCube(2.0);
  const glm::dmat3 axes = random.rotation();
  // An octagon without trigonometry.
  constexpr std::array<std::pair<double, double>, 8> kRim = {
      {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};
  std::vector<glm::dvec3> rim;
  for (const auto& [x, y] : kRim) {
    const double sunk = random.uniform(-0.3, 0.3);
    rim.push_back(apex + axes * glm::dvec3(x, y, sunk));
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    drawn.primitives.push_back(triangleOf(apex, rim[i], rim[(i + 1) % rim.size()]));
  }
  const Corners corners = cornersOf(drawn.primitives[random.integer(0, 7)]);
  const bool atVertex = random.chance(0.5);
  const double along = atVertex ? 0.0 : random.uniform(0.0, 0.5);
  const glm::dvec3 target = corners[0] + (corners[1] - corners[0]) * along;
  const glm::dvec3 from = axes[2] + 0.5 * random.inBall();
  drawn.ray = rayTowards(target + from * random.uniform(1.0, 10.0), target);
}

/// Points on the unit sphere, and triangles of three of their indices.
struct Net {
  std::vector<glm::dvec3> points;
  std::vector<std::array<int, 3>> triangles;
};

Net icosahedron() {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  Net net;
  for (const auto& [x, y] : {std::pair{-1.0, g}, {1.0, g}, {-1.0, -g}, {1.0, -g}}) {
    net.points.emplace_back(x, y, 0.0);
  }
  for (int i = 0; i < 4; ++i) net.points.emplace_back(0.0, net.points[i].x, net.points[i].y);
  for (int i = 0; i < 4; ++i) net.points.emplace_back(net.points[i].y, 0.0, net.points[i].x);
  for (glm::dvec3& point : net.points) point /= glm::length(point);
  net.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                   {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                   {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                   {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return net;
}

int middleOf(Net& net, std::map<std::pair<int, int>, int>& known, int a, int b) {
  const auto [entry, isNew] =
      known.try_emplace(std::minmax(a, b), static_cast<int>(net.points.size()));
  if (isNew) {
    const glm::dvec3 middle = net.points[a] + net.points[b];
    net.points.push_back(middle / glm::length(middle));
  }
  return entry->second;
}

Net subdivided(Net net) {
  std::map<std::pair<int, int>, int> known;
  std::vector<std::array<int, 3>> finer;
  for (const auto [a, b, c] : net.triangles) {
    const int ab = middleOf(net, known, a, b);
    const int bc = middleOf(net, known, b, c);
    const int ca = middleOf(net, known, c, a);
    for (const auto& part : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      finer.push_back(part);
    }
  }
  net.triangles = std::move(finer);
  return net;
}

std::vector<CasePrimitive> icosphere(CaseRandom& random) {
  static const Net net = subdivided(subdivided(icosahedron()));
  const glm::dmat3 axes = random.rotation();
  const glm::dvec3 centre = random.inCube(10.0);
  const double radius = random.logarithmic(0.1, 10.0);
  std::vector<CasePrimitive> triangles;
  for (const auto [a, b, c] : net.triangles) {
    const auto at = [&](int index) { return centre + axes * net.points[index] * radius; };
    triangles.push_back(triangleOf(at(a), at(b), at(c)));
  }
  return triangles;
}

/// From outside through an edge or a vertex towards the inside.
void drawIcosphereRay(CaseRandom& random, Case& drawn) {
  const int last = static_cast<int>(drawn.primitives.size()) - 1;
  const Corners corners = cornersOf(drawn.primitives[random.integer(0, last)]);
  const glm::dvec3 target = random.chance(0.5) ? corners[0] : pointOnEdge(random, corners);
  const glm::dvec3 outward = unitNormal(corners);
  const glm::dvec3 from = outward + 0.7 * random.inBall();
  drawn.ray = rayTowards(target + from * (sizeOf(corners) * random.uniform(2.0, 20.0)), target);
}

FamilyRecipe triangleRecipe(const char* name, const char* what, Draw draw,
                            Expectation expectation = Expectation::exact) {
  return {{name, what, FamilyKind::triangle, expectation}, std::move(draw), {}};
}

}  // namespace

std::vector<FamilyRecipe> triangleFamilies() {
  constexpr Expectation closed = Expectation::closed;
  std::vector<FamilyRecipe> recipes = {
      triangleRecipe("triangle-generic", "aimed at the triangle or near it", scaled(1.0, 0.0)),
      triangleRecipe("triangle-edge", "aimed at an edge", drawEdge),
      triangleRecipe("triangle-vertex", "aimed at a vertex", drawVertex),
      triangleRecipe("triangle-edge-exact", "through an edge, in numbers that floats hold",
                     drawEdgeExactly),
      triangleRecipe("triangle-sliver-1e4", "length / height 1e3 to 1e5", sliver(1e3, 1e5)),
      triangleRecipe("triangle-sliver-1e6", "length / height 1e5 to 1e7", sliver(1e5, 1e7)),
      triangleRecipe("triangle-translated", "size 10, moved by 1e6 along each axis",
                     scaled(10.0, 1e6)),
      triangleRecipe("triangle-far", "distance / size 1e2 to 1e6", far(1e2, 1e6)),
      triangleRecipe("triangle-grazing", "sine of the angle 1e-6 to 1e-2", drawGrazing),
      triangleRecipe("triangle-skinny", "10 x 1 under sines of 1e-5 to 1e-2, from 100 to 600",
                     drawSkinnyGrazing),
      triangleRecipe("triangle-small", "the usual scene times 1e-5", scaled(1e-5, 0.0)),
      triangleRecipe("triangle-large", "the usual scene times 1e4", scaled(1e4, 0.0)),
      triangleRecipe("triangle-direction", "|direction| 1e-12 to 1e12", directed(1e-12, 1e12)),
      triangleRecipe("triangle-direction-long", "|direction| 1e15 to 1e37", directed(1e15, 1e37)),
      triangleRecipe("triangle-direction-short", "|direction| 1e-37 to 1e-15",
                     directed(1e-37, 1e-15)),
      triangleRecipe("triangle-far-t", "hits at t of 1e18 to 1e37", drawFarT),
      triangleRecipe("triangle-in-plane", "ray in its plane: a miss", drawInPlane),
      triangleRecipe("triangle-no-area", "corners on a line: a miss", drawNoArea),
      triangleRecipe("triangle-shared-edge", "at the diagonal of a quad: no crack", drawSharedEdge,
                     closed),
      triangleRecipe("triangle-fan", "at the vertex and edges of a fan of 8: no crack", drawFan,
                     closed),
  };
  const Family sphere = {"triangle-icosphere", "at edges and vertices of 320 triangles: no leak",
                         FamilyKind::triangle, closed};
  recipes.push_back({sphere, drawIcosphereRay, icosphere});
  return recipes;
}

}  // namespace twintrace
