#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "common/generate/recipes.h"

namespace twintrace {
namespace {

constexpr int kSides = 8;
constexpr std::int64_t kBranchPrimitives = 2 * kSides + 1;
constexpr double kThickness = 0.11;  // radius of a branch's foot over its length
constexpr double kTaper = 0.7;       // radius at the end over that at the foot

/// How a fork leaves its branch, which grows along z: cosine and sine of the angle, length over that
/// of the branch, and cosine and sine of a turn about the branch.
struct Fork {
  double cosine, sine, contraction, turnCosine, turnSine;
};
constexpr std::array<Fork, 2> kForks = {
    {{0.8, 0.6, 0.72, 0.0, 1.0}, {12.0 / 13.0, -5.0 / 13.0, 0.8, 0.28, 0.96}}};

struct Branch {
  glm::dvec3 foot;
  glm::dmat3 frame;  // columns are the axes
  double length;
};

std::array<glm::dvec2, kSides> circle() {
  const double d = std::sqrt(0.5);
  return {{{1, 0}, {d, d}, {0, 1}, {-d, d}, {-1, 0}, {-d, -d}, {0, -1}, {d, -d}}};
}

/// In the scene, where y is up.
glm::dvec3 upright(const glm::dvec3& p) { return {p.x, p.z - 1.0, -p.y}; }

class Tree {
 public:
  explicit Tree(Parts& parts) : parts_(parts) {}

  void grow(const Branch& branch, int levels) {
    const double radius = branch.length * kThickness;
    const glm::dvec3 end = branch.foot + branch.frame[2] * branch.length;
    addTube(branch, radius, radius * kTaper);
    parts_.spheres.push_back({glm::vec3(upright(end)), float(radius * kTaper)});
    if (levels == 0) return;
    for (const Fork& fork : kForks) {
      const glm::dmat3 turn = {{fork.turnCosine, fork.turnSine, 0.0},
                               {-fork.turnSine, fork.turnCosine, 0.0},
                               {0.0, 0.0, 1.0}};
      const glm::dmat3 lean = {
          {fork.cosine, 0.0, -fork.sine}, {0.0, 1.0, 0.0}, {fork.sine, 0.0, fork.cosine}};
      grow({end, branch.frame * turn * lean, branch.length * fork.contraction}, levels - 1);
    }
  }

 private:
  void addTube(const Branch& branch, double footRadius, double endRadius) {
    Mesh& mesh = parts_.mesh;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec2& p : circle_) {
      const glm::dvec3 out = branch.frame[0] * p.x + branch.frame[1] * p.y;
      const glm::dvec3 end = branch.foot + branch.frame[2] * branch.length;
      mesh.positions.emplace_back(upright(branch.foot + out * footRadius));
      mesh.positions.emplace_back(upright(end + out * endRadius));
    }
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t here = first + 2 * side;
      const std::uint32_t next = first + 2 * ((side + 1) % kSides);
      mesh.triangles.push_back({here, next, next + 1});
      mesh.triangles.push_back({here, next + 1, here + 1});
    }
  }

  const std::array<glm::dvec2, kSides> circle_ = circle();
  Parts& parts_;
};

}  // namespace

std::int64_t treeCount(int levels) {
  return kBranchPrimitives * ((std::int64_t{2} << levels) - 1);
}

std::vector<Parts> makeTree(int levels, std::uint32_t) {
  std::vector<Parts> objects(1);
  Tree(objects[0]).grow({glm::dvec3(0.0), glm::dmat3(1.0), 0.55}, levels);
  return objects;
}

}  // namespace twintrace
