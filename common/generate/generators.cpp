#include "common/generate/generators.h"

#include <algorithm>

#include "common/generate/recipes.h"

namespace twintrace {
namespace {

std::int64_t itself(int count) {
  return count;
}

}  // namespace

const std::vector<Generator>& generators() {
  static const std::vector<Generator> all = {
      {"sphereflake", "levels of spheres on spheres", 0, 7, sphereflakeCount, makeSphereflake},
      {"tetra", "levels of Sierpinski's tetrahedron", 1, 11, tetraCount, makeTetra},
      {"mount", "levels of displacement", 1, 11, mountCount, makeMount},
      {"tree", "forks from the trunk to a twig", 0, 18, treeCount, makeTree},
      {"spheres", "number of spheres", 1, static_cast<int>(kMaxGenerated), itself, makeSpheres},
      {"boxes", "number of boxes", 1, static_cast<int>(kMaxGenerated), itself, makeBoxes},
      {"row", "levels of subdivision of ten balls", 0, 8, rowCount, makeRow},
  };
  return all;
}

const Generator* findGenerator(std::string_view name) {
  const auto found = std::ranges::find(generators(), name, &Generator::name);
  return found == generators().end() ? nullptr : &*found;
}

}  // namespace twintrace
