#include "common/generate/generators.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <tuple>

#include "tests/catch.h"

namespace twintrace {
namespace {

std::vector<Parts> make(std::string_view name, int size, std::uint32_t seed = 1) {
  return findGenerator(name)->make(size, seed);
}

std::int64_t countOf(const std::vector<Parts>& objects) {
  std::size_t count = 0;
  for (const Parts& parts : objects) {
    count += parts.spheres.size() + parts.boxes.size() + parts.mesh.triangles.size();
  }
  return static_cast<std::int64_t>(count);
}

/// A few sizes that take no time.
std::vector<int> smallSizes(const Generator& generator) {
  if (generator.primitives(7) == 7) return {1, 2, 10, 1000};
  return {generator.smallest, generator.smallest + 1, 3, 4};
}

std::vector<glm::vec3> pointsOf(const Parts& parts) {
  std::vector<glm::vec3> points = parts.mesh.positions;
  for (const SphereShape& sphere : parts.spheres) {
    points.push_back(sphere.center + sphere.radius);
    points.push_back(sphere.center - sphere.radius);
  }
  for (const BoxShape& box : parts.boxes) points.emplace_back(box.center);
  return points;
}

std::vector<std::string> numbersOf(const std::vector<Parts>& objects) {
  std::vector<std::string> numbers;
  const auto add = [&](const auto& v) {
    for (int i = 0; i < 3; ++i) numbers.push_back(Catch::StringMaker<double>::convert(v[i]));
  };
  for (const Parts& parts : objects) {
    for (const SphereShape& sphere : parts.spheres) {
      add(sphere.center);
      add(glm::vec3(sphere.radius));
    }
    for (const BoxShape& box : parts.boxes) {
      add(box.center);
      add(box.size);
      add(box.rotation.value_or(glm::vec3(-1.0f)));
    }
    for (const glm::vec3& position : parts.mesh.positions) add(position);
    for (const Corners& corners : parts.mesh.triangles) add(corners);
  }
  return numbers;
}

/// How often each edge of a mesh is walked each way, by the places of its ends.
using Place = std::tuple<float, float, float>;
std::map<std::pair<Place, Place>, int> edgesOf(const Mesh& mesh) {
  std::map<std::pair<Place, Place>, int> edges;
  const auto place = [&](std::uint32_t i) {
    // -0 and 0 compare equal.
    return Place(mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z);
  };
  for (const Corners& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{place(corners[i]), place(corners[(i + 1) % 3])}];
    }
  }
  return edges;
}

/// Each edge is walked as often one way as the other.
bool isClosed(const Mesh& mesh) {
  const auto edges = edgesOf(mesh);
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != count) return false;
  }
  return !edges.empty();
}

/// Six times the volume that the triangles enclose; positive if they face outwards.
double contentOf(const Mesh& mesh) {
  double sum = 0.0;
  for (const Corners& c : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[c[0]]), b(mesh.positions[c[1]]), d(mesh.positions[c[2]]);
    sum += glm::dot(a, glm::cross(b, d));
  }
  return sum / 6.0;
}

TEST_CASE("Generators make as many primitives as they say", "[generate]") {
  for (const Generator& generator : generators()) {
    for (const int size : smallSizes(generator)) {
      INFO(generator.name << " " << size);
      CHECK(countOf(generator.make(size, 1)) == generator.primitives(size));
    }
  }
}

TEST_CASE("Generators have the published counts of primitives", "[generate]") {
  CHECK(countOf(make("sphereflake", 0)) == 1);
  CHECK(countOf(make("sphereflake", 2)) == 91);
  CHECK(countOf(make("sphereflake", 4)) == 7381);
  CHECK(findGenerator("sphereflake")->primitives(5) == 66430);
  CHECK(countOf(make("tetra", 6)) == 4096);
  CHECK(countOf(make("mount", 6)) == 8192);
  CHECK(countOf(make("tree", 0)) == 17);
  CHECK(countOf(make("tree", 3)) == 17 * 15);
  CHECK(countOf(make("row", 0)) == 80);
  CHECK(make("row", 1).size() == 10);
  CHECK(make("row", 1)[9].mesh.triangles.size() == 32);
}

TEST_CASE("The largest size of a generator keeps to the limit, and the next does not",
          "[generate]") {
  for (const Generator& generator : generators()) {
    INFO(generator.name);
    CHECK(generator.primitives(generator.largest) <= kMaxGenerated);
    CHECK(generator.primitives(generator.largest + 1) > kMaxGenerated);
    CHECK(generator.primitives(generator.smallest) >= 1);
  }
}

TEST_CASE("Generators make the same from the same seed", "[generate]") {
  for (const Generator& generator : generators()) {
    const int size = smallSizes(generator).back();
    INFO(generator.name << " " << size);
    CHECK(numbersOf(generator.make(size, 7)) == numbersOf(generator.make(size, 7)));
  }
}

TEST_CASE("Generators that draw random numbers make something else from another seed",
          "[generate]") {
  for (const std::string_view name : {"mount", "spheres", "boxes", "row"}) {
    INFO(name);
    CHECK(numbersOf(make(name, 3, 7)) != numbersOf(make(name, 3, 8)));
  }
}

TEST_CASE("Generators fill about the cube from -1 to 1", "[generate]") {
  for (const Generator& generator : generators()) {
    glm::vec3 low(1e9f), high(-1e9f);
    for (const Parts& parts : generator.make(smallSizes(generator).back(), 3)) {
      for (const glm::vec3& point : pointsOf(parts)) {
        low = glm::min(low, point);
        high = glm::max(high, point);
      }
    }
    INFO(generator.name << " from " << low.x << " " << low.y << " " << low.z << " to " << high.x
                        << " " << high.y << " " << high.z);
    for (int i = 0; i < 3; ++i) {
      CHECK(low[i] >= -1.2f);
      CHECK(high[i] <= 1.2f);
    }
    const glm::vec3 extent = high - low;
    CHECK(std::max({extent.x, extent.y, extent.z}) >= 1.5f);
  }
}

TEST_CASE("Generators make no triangle without area, whose corners are there", "[generate]") {
  for (const auto& [name, size] :
       std::map<std::string, int>{{"tetra", 7}, {"mount", 7}, {"tree", 9}, {"row", 5}}) {
    std::size_t bad = 0;
    for (const Parts& parts : make(name, size)) {
      const auto& p = parts.mesh.positions;
      for (const Corners& c : parts.mesh.triangles) {
        const bool there = std::max({c[0], c[1], c[2]}) < p.size();
        if (!there || glm::length(glm::cross(glm::dvec3(p[c[1]] - p[c[0]]),
                                             glm::dvec3(p[c[2]] - p[c[0]]))) <= 0.0) {
          ++bad;
        }
      }
    }
    INFO(name);
    CHECK(bad == 0);
  }
}

TEST_CASE("Spheres of a flake touch those they sit on", "[generate]") {
  const std::vector<SphereShape> spheres = make("sphereflake", 3)[0].spheres;
  REQUIRE(spheres.size() == 820);
  CHECK(spheres[0].radius == 0.5f);
  // Depth first: a sphere's parent is the last one before it that is three times as large.
  std::size_t apart = 0;
  for (std::size_t i = 1; i < spheres.size(); ++i) {
    std::size_t parent = i;
    while (spheres[parent].radius < 2.0f * spheres[i].radius) --parent;
    const double distance =
        glm::length(glm::dvec3(spheres[i].center) - glm::dvec3(spheres[parent].center));
    const double sum = double(spheres[i].radius) + spheres[parent].radius;
    CHECK(spheres[parent].radius == Approx(3.0 * spheres[i].radius));
    // Centers are rounded to float: at most 1 + sqrt(3) 2^-24 apart from where they should be.
    if (std::abs(distance - sum) > 4.0 * 0x1p-24) ++apart;
  }
  CHECK(apart == 0);
}

TEST_CASE("Spheres of a flake do not run into their siblings", "[generate]") {
  const std::vector<SphereShape> spheres = make("sphereflake", 1)[0].spheres;
  for (std::size_t i = 1; i < spheres.size(); ++i) {
    for (std::size_t j = 1; j < i; ++j) {
      const double distance =
          glm::length(glm::dvec3(spheres[i].center) - glm::dvec3(spheres[j].center));
      CHECK(distance > double(spheres[i].radius) + spheres[j].radius);
    }
  }
}

TEST_CASE("Sierpinski's tetrahedra are closed and face outwards", "[generate]") {
  // A tetrahedron that takes every other corner of a cube of side 2 has volume 8 / 3; each level
  // leaves four of half the size.
  double content = 8.0 / 3.0;
  for (int levels = 1; levels <= 4; ++levels) {
    const Mesh mesh = make("tetra", levels)[0].mesh;
    CHECK(isClosed(mesh));
    CHECK(contentOf(mesh) == Approx(content));
    content /= 2.0;
  }
}

TEST_CASE("Balls in a row are closed, face outwards and keep apart", "[generate]") {
  for (const int levels : {0, 1, 4}) {
    float right = -2.0f;
    for (const Parts& parts : make("row", levels)) {
      CHECK(isClosed(parts.mesh));
      float low = 2.0f, high = -2.0f;
      Mesh centered = parts.mesh;
      for (glm::vec3& p : centered.positions) {
        low = std::min(low, p.x);
        high = std::max(high, p.x);
      }
      CHECK(contentOf(centered) > 0.0);
      CHECK(low > right);
      right = high;
    }
  }
}

TEST_CASE("A mountain is one sheet over the square, without seams", "[generate]") {
  const Mesh mesh = make("mount", 4)[0].mesh;
  CHECK(mesh.positions.size() == 17 * 17);
  CHECK(mesh.textureCoordinates.size() == mesh.positions.size());
  std::size_t rim = 0;
  const auto edges = edgesOf(mesh);
  for (const auto& [edge, count] : edges) {
    CHECK(count == 1);
    if (!edges.contains({edge.second, edge.first})) ++rim;
  }
  CHECK(rim == 4 * 16);
  for (const Corners& c : mesh.triangles) {
    const glm::vec3 up = glm::cross(mesh.positions[c[1]] - mesh.positions[c[0]],
                                    mesh.positions[c[2]] - mesh.positions[c[0]]);
    CHECK(up.y > 0.0f);
  }
}

TEST_CASE("A tree's branches end in spheres as wide as they are", "[generate]") {
  const Parts parts = make("tree", 3)[0];
  REQUIRE(parts.mesh.positions.size() == 16 * parts.spheres.size());
  for (std::size_t branch = 0; branch < parts.spheres.size(); ++branch) {
    const SphereShape& sphere = parts.spheres[branch];
    for (std::size_t i = 1; i < 16; i += 2) {
      const glm::vec3 end = parts.mesh.positions[16 * branch + i];
      CHECK(glm::length(end - sphere.center) == Approx(sphere.radius).epsilon(1e-5));
    }
  }
}

TEST_CASE("Random primitives are about as dense whatever their number", "[generate]") {
  for (const int count : {10, 1000, 100000}) {
    double spheres = 0.0, boxes = 0.0;
    const std::vector<SphereShape> balls = make("spheres", count)[0].spheres;
    for (const SphereShape& sphere : balls) {
      spheres += std::pow(sphere.radius, 3.0) * 4.18879;
    }
    const std::vector<BoxShape> cubes = make("boxes", count)[0].boxes;
    for (const BoxShape& box : cubes) {
      boxes += box.size.x * box.size.y * box.size.z;
    }
    // Expected: mean radius^3 of spheres 8 * 4.19 * (0.45^4 - 0.15^4) / (4 * 0.3) and 8 * 0.5^3;
    // ten differ from their mean by a factor of two at most.
    CHECK(spheres == Approx(1.13).epsilon(count == 10 ? 0.7 : 0.1));
    CHECK(boxes == Approx(1.0).epsilon(count == 10 ? 0.7 : 0.15));
  }
}

TEST_CASE("Every second random box is turned", "[generate]") {
  const std::vector<BoxShape> boxes = make("boxes", 10)[0].boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) CHECK(boxes[i].isTurned() == (i % 2 == 1));
}

TEST_CASE("findGenerator knows nothing of other names", "[generate]") {
  CHECK(findGenerator("teapot") == nullptr);
  CHECK(findGenerator("tetra")->name == "tetra");
}

}  // namespace
}  // namespace twintrace
