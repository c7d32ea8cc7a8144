#include <cmath>

#include "common/cast/case_random.h"
#include "common/generate/recipes.h"

namespace twintrace {
namespace {

/// Mean distance of `count` neighbours in the cube from -1 to 1: 2 / cube root of count. By Newton's
/// iteration, since the standard libraries' cube roots differ.
double spacing(int count) {
  double root = 1.0;
  for (int i = 0; i < 80; ++i) root -= (root * root * root - count) / (3.0 * root * root);
  return 2.0 / root;
}

}  // namespace

std::vector<Parts> makeSpheres(int count, std::uint32_t seed) {
  std::vector<Parts> objects(1);
  const double unit = spacing(count);
  CaseRandom random(mixSeed(seed, 0));
  for (int i = 0; i < count; ++i) {
    const glm::vec3 center(random.inCube(1.0));
    objects[0].spheres.push_back({center, float(unit * random.uniform(0.15, 0.45))});
  }
  return objects;
}

std::vector<Parts> makeBoxes(int count, std::uint32_t seed) {
  std::vector<Parts> objects(1);
  const double unit = spacing(count);
  CaseRandom random(mixSeed(seed, 1));
  for (int i = 0; i < count; ++i) {
    BoxShape box;
    box.center = random.inCube(1.0);
    box.size = {random.uniform(0.1, 0.9), random.uniform(0.1, 0.9), random.uniform(0.1, 0.9)};
    box.size *= unit;
    const glm::vec3 turn(random.inCube(180.0));
    if (i % 2 == 1) box.rotation = turn;
    objects[0].boxes.push_back(box);
  }
  return objects;
}

}  // namespace twintrace
