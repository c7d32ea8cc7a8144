#include "common/scene/expand_shapes.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "common/generate/generators.h"
#include "common/scene/reader.h"
#include "common/scene/rotation.h"
#include "tests/catch.h"
#include "tests/unit/experiments/temporary_directory.h"
#include "tests/unit/scene/faults.h"

namespace twintrace {
namespace {

using test::TemporaryDirectory;
using test::writeBytes;

const std::string kObject = std::string(kWhite) + "[[objects]]\nmaterial = \"white\"\n";
const std::string kMesh = kObject + "shape = \"mesh\"\nfile = \"a.obj\"\n";
const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";

std::string generate(const std::string& generator, int size, const std::string& more = "") {
  return kObject + "shape = \"generate\"\ngenerator = \"" + generator +
         "\"\nsize = " + std::to_string(size) + "\n" + more;
}

/// A scene file beside a.obj, read.
Scene readWith(const std::string& object, const std::string& scene) {
  const TemporaryDirectory directory;
  writeBytes(directory.file("a.obj"), object);
  writeBytes(directory.file("s.toml"), scene);
  return readScene(directory.file("s.toml"));
}

/// What reading such a scene throws, its folder left out.
std::string faultsWith(const std::string& object, const std::string& scene) {
  const TemporaryDirectory directory;
  writeBytes(directory.file("a.obj"), object);
  writeBytes(directory.file("s.toml"), scene);
  try {
    readScene(directory.file("s.toml"));
    return "";
  } catch (const FileError& error) {
    std::string text = error.what();
    const std::string folder = directory.file("");
    for (std::size_t at = text.find(folder); at != text.npos; at = text.find(folder)) {
      text.erase(at, folder.size());
    }
    return text;
  }
}

const Parts& partsOf(const Scene& scene, std::size_t object) {
  const auto& shape = scene.objects.at(object).shape;
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return *mesh->parts;
  return *std::get<GeneratedShape>(shape).parts;
}

void checkClose(const glm::dvec3& a, const glm::dvec3& b) {
  INFO(a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z);
  CHECK(glm::length(a - b) < 1e-6);
}

TEST_CASE("A mesh is scaled, turned and moved, in this order", "[scene]") {
  const Scene scene =
      readWith(kTriangle, kMesh + "scale = 2\nrotation = [0, 0, 90]\ntranslation = [10, 0, 5]\n");
  const Mesh& mesh = partsOf(scene, 0).mesh;
  REQUIRE(mesh.triangles.size() == 1);
  const Corners& c = mesh.triangles[0];
  checkClose(mesh.positions[c[0]], {10, 0, 5});
  checkClose(mesh.positions[c[1]], {10, 2, 5});
  checkClose(mesh.positions[c[2]], {8, 2, 5});
}

TEST_CASE("A mesh without a placement stays where it is to the bit", "[scene]") {
  const std::string odd = "v 0.1 0.3 0.7\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
  const Scene scene = readWith(odd, kMesh);
  const Mesh& mesh = partsOf(scene, 0).mesh;
  CHECK(mesh.positions[mesh.triangles[0][0]] == glm::vec3(0.1f, 0.3f, 0.7f));
}

TEST_CASE("Normals of a smooth mesh turn with it and stay unit vectors", "[scene]") {
  const Scene smooth =
      readWith(kTriangle, kMesh + "smooth = true\nscale = 3\nrotation = [90, 0, 0]\n");
  for (const glm::vec3& normal : partsOf(smooth, 0).mesh.normals) checkClose(normal, {0, -1, 0});
  CHECK(partsOf(smooth, 0).mesh.normals.size() == 3);
  CHECK(partsOf(readWith(kTriangle, kMesh), 0).mesh.normals.empty());
}

TEST_CASE("What a mesh leaves out goes to the scene's warnings", "[scene]") {
  const Scene scene = readWith(kTriangle + "f 1 1 2\n", kMesh);
  REQUIRE(scene.warnings.size() == 1);
  CHECK_THAT(scene.warnings[0],
             Catch::Matchers::EndsWith("a.obj: 1 triangle without area is left out"));
  CHECK(readWith(kTriangle, kMesh).warnings.empty());
}

TEST_CASE("Meshes that are no use are faults of their objects, all at once", "[scene]") {
  const std::string bad = "s.toml:4:1: found no triangle in 'a.obj', expected at least one";
  CHECK(faultsWith(kPoints, kMesh) == bad);
  CHECK(faultsWith(kPoints, kMesh + "[[objects]]\nmaterial = \"white\"\nshape = \"mesh\"\n"
                                    "file = \"a.obj\"\n") ==
        bad + "\ns.toml:8:1: found no triangle in 'a.obj', expected at least one");
  CHECK(faultsWith("", kObject + "shape = \"mesh\"\nfile = \"b.obj\"\n") ==
        "s.toml:7:8: found no file 'b.obj', expected a readable mesh file");
  CHECK(faultsWith("", kObject + "shape = \"mesh\"\nfile = \".\"\n") ==
        "s.toml:7:8: found no file '.', expected a readable mesh file");
  CHECK(faultsWith("", kObject + "shape = \"mesh\"\nfile = \"s.toml\"\n") ==
        "s.toml:4:1: found mesh file 's.toml', expected one that ends in .obj, .ply, .gltf, .glb "
        "or .nff");
}

TEST_CASE("What a placement makes too large or too small is a fault", "[scene]") {
  const std::string large =
      "s.toml:4:1: found coordinates beyond 1e18 in object 'mesh-0' as scaled and moved, expected "
      "smaller ones";
  CHECK(faultsWith("v 0 0 0\nv 1e3 0 0\nv 1 1 0\nf 1 2 3\n", kMesh + "scale = 1e17") == large);
  CHECK(faultsWith("v 0 0 0\nv 9e17 0 0\nv 1 1 0\nf 1 2 3\n",
                   kMesh + "translation = [9e17, 0, 0]") == large);
  CHECK(faultsWith("", generate("sphereflake", 1, "scale = 1e-18")) ==
        "s.toml:4:1: found spheres with radii below 1e-18 in object 'generate-0' as scaled, "
        "expected a larger scale");
  CHECK(faultsWith("", generate("boxes", 3, "translation = [1e18, 0, 0]\nscale = 1e18")) ==
        "s.toml:4:1: found coordinates beyond 1e18 in object 'generate-0' as scaled and moved, "
        "expected smaller ones");
}

TEST_CASE("Generated spheres are scaled, turned and moved", "[scene]") {
  const Scene scene = readWith("", generate("sphereflake", 1,
                                            "scale = 2\nrotation = [0, 90, 0]\n"
                                            "translation = [1, 2, 3]\n"));
  const std::vector<Parts> plain = findGenerator("sphereflake")->make(1, 1);
  const std::vector<SphereShape>& spheres = partsOf(scene, 0).spheres;
  REQUIRE(spheres.size() == 10);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const glm::vec3 p = plain[0].spheres[i].center;
    checkClose(spheres[i].center, {2.0f * p.z + 1.0f, 2.0f * p.y + 2.0f, -2.0f * p.x + 3.0f});
    CHECK(spheres[i].radius == 2.0f * plain[0].spheres[i].radius);
  }
}

TEST_CASE("Generated boxes keep their shape under a turn", "[scene]") {
  const Scene scene = readWith("", generate("boxes", 20,
                                            "scale = 2\nrotation = [20, 90, 40]\n"
                                            "translation = [1, 2, 3]\n"));
  const std::vector<BoxShape> plain = findGenerator("boxes")->make(20, 1)[0].boxes;
  const std::vector<BoxShape>& boxes = partsOf(scene, 0).boxes;
  const glm::dmat3 turn = rotationMatrix({20.0f, 90.0f, 40.0f});
  REQUIRE(boxes.size() == 20);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    // Where two corners come to lie.
    for (const glm::dvec3& corner : {glm::dvec3(1, 1, 1), glm::dvec3(-1, 1, 0.5)}) {
      const glm::dmat3 own = rotationMatrix(plain[i].rotation.value_or(glm::vec3(0.0f)));
      const glm::dvec3 wanted =
          2.0 * (turn * (plain[i].center + own * (0.5 * corner * plain[i].size))) +
          glm::dvec3(1, 2, 3);
      const glm::dmat3 turned = rotationMatrix(boxes[i].rotation.value_or(glm::vec3(0.0f)));
      checkClose(boxes[i].center + turned * (0.5 * corner * boxes[i].size), wanted);
    }
  }
}

TEST_CASE("Generated boxes keep their rotation to the bit without a turn", "[scene]") {
  const Scene scene = readWith("", generate("boxes", 10, "scale = 2\n"));
  const std::vector<BoxShape> plain = findGenerator("boxes")->make(10, 1)[0].boxes;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(partsOf(scene, 0).boxes[i].rotation == plain[i].rotation);
    CHECK(plain[i].isTurned() == (i % 2 == 1));
  }
}

TEST_CASE("A generator of several objects becomes as many, named after it", "[scene]") {
  const Scene scene = readWith("", generate("row", 0, "name = \"balls\"\n") +
                                       "[[objects]]\nmaterial = \"white\"\nshape = \"sphere\"\n"
                                       "center = [0, 0, 0]\nradius = 1\n");
  REQUIRE(scene.objects.size() == 11);
  CHECK(scene.objects[0].name == "balls-0");
  CHECK(scene.objects[9].name == "balls-9");
  CHECK(scene.objects[10].name == "sphere-1");
  for (std::size_t i = 0; i < 10; ++i) CHECK(partsOf(scene, i).mesh.triangles.size() == 8);
}

TEST_CASE("Names that a generator's objects and others share are faults", "[scene]") {
  CHECK(faultsWith("", generate("row", 0, "name = \"balls\"\n") +
                           "[[objects]]\nmaterial = \"white\"\nshape = \"sphere\"\n"
                           "center = [0, 0, 0]\nradius = 1\nname = \"balls-3\"\n") ==
        "s.toml:10:1: found a second object named 'balls-3' (the first is in line 4), expected a "
        "name of its own");
}

TEST_CASE("The seed of a generator decides what it makes", "[scene]") {
  const auto height = [](const std::string& seed) {
    return partsOf(readWith("", generate("mount", 1, seed)), 0).mesh.positions[4].y;
  };
  CHECK(height("") == height("seed = 1"));
  CHECK(height("seed = 1") != height("seed = 2"));
}

}  // namespace
}  // namespace twintrace
