#include "common/nff/nff_file.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "common/base/error.h"
#include "tests/catch.h"
#include "tests/unit/experiments/temporary_directory.h"

using namespace twintrace;

namespace {

const std::string kFill = "f 1 0.5 0.25 0.8 0.2 40 0 1\n";

/// The messages of a file, a line each; empty if there are none.
std::string faultsOf(const std::string& text) {
  try {
    parseNff(text, "a.nff");
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

std::string faultsAfterFill(const std::string& text) {
  return faultsOf(kFill + text);
}

NffFile parsed(const std::string& text) {
  return parseNff(kFill + text, "a.nff");
}

const Parts& onlyParts(const NffFile& file) {
  REQUIRE(file.parts.size() == 1);
  return file.parts[0].parts;
}

double areaOf(const Mesh& mesh) {
  double sum = 0.0;
  for (const Corners& c : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[c[0]]), b(mesh.positions[c[1]]), d(mesh.positions[c[2]]);
    sum += glm::length(glm::cross(b - a, d - a)) * 0.5;
  }
  return sum;
}

}  // namespace

TEST_CASE("parseNff reads the view", "[nff]") {
  const NffFile file =
      parsed("v\nfrom 1 2 3\nat -1 .5 +2e0\nup 0 0 1\nangle 45.5\nhither 1\nresolution 512 256\n");
  REQUIRE(file.view);
  CHECK(file.view->from == glm::dvec3(1, 2, 3));
  CHECK(file.view->at == glm::dvec3(-1, 0.5, 2));
  CHECK(file.view->up == glm::dvec3(0, 0, 1));
  CHECK(file.view->angle == 45.5);
  CHECK(file.view->width == 512);
  CHECK(file.view->height == 256);
}

TEST_CASE("parseNff reads background and lights with and without colour", "[nff]") {
  const NffFile file = parseNff("b 0.1 0.2 0.3\nl 1 2 3\nl 4 5 6 0.5 0.25 1\nl 7 8 9\n", "a.nff");
  CHECK(file.background == glm::vec3(0.1f, 0.2f, 0.3f));
  REQUIRE(file.lights.size() == 3);
  CHECK(file.lights[0].position == glm::vec3(1, 2, 3));
  CHECK_FALSE(file.lights[0].color);
  CHECK(file.lights[1].color == glm::vec3(0.5f, 0.25f, 1.0f));
  CHECK(file.lights[2].position == glm::vec3(7, 8, 9));
}

TEST_CASE("parseNff gathers surfaces by fill, the same fill in one part", "[nff]") {
  const NffFile file = parseNff(
      kFill + "s 1 2 3 4\nf 0 1 0 1 0 0 0 0\ns 0 0 0 1\n" + kFill + "s 5 6 7 -8\n", "a.nff");
  REQUIRE(file.parts.size() == 2);
  CHECK(file.parts[0].fill.color == glm::vec3(1.0f, 0.5f, 0.25f));
  CHECK(file.parts[0].fill.diffuse == 0.8f);
  CHECK(file.parts[0].fill.specular == 0.2f);
  CHECK(file.parts[0].fill.shine == 40.0f);
  CHECK(file.parts[0].fill.transmittance == 0.0f);
  CHECK(file.parts[0].fill.ior == 1.0f);
  REQUIRE(file.parts[0].parts.spheres.size() == 2);
  CHECK(file.parts[0].parts.spheres[0].center == glm::vec3(1, 2, 3));
  CHECK(file.parts[0].parts.spheres[0].radius == 4.0f);
  CHECK(file.parts[0].parts.spheres[1].radius == 8.0f);
  CHECK(file.parts[1].parts.spheres.size() == 1);
  CHECK_FALSE(file.parts[0].curved);
}

TEST_CASE("parseNff cuts up a concave polygon and leaves its notch free", "[nff]") {
  const NffFile file = parsed("p 4\n0 0 1\n4 0 1\n1 1 1\n0 4 1\n");
  const Mesh& mesh = onlyParts(file).mesh;
  CHECK(mesh.triangles.size() == 2);
  CHECK(areaOf(mesh) == Approx(4.0));
  for (const glm::vec3& normal : mesh.normals) CHECK(normal == glm::vec3(0, 0, 1));
}

TEST_CASE("parseNff keeps the normals of patches as unit vectors", "[nff]") {
  const NffFile file = parsed("pp 3\n0 0 0 0 0 2\n1 0 0 0 3 4\n0 1 0 0 0 0\n");
  CHECK(file.parts[0].curved);
  const Mesh& mesh = onlyParts(file).mesh;
  REQUIRE(mesh.normals.size() == 3);
  CHECK(mesh.normals[0] == glm::vec3(0, 0, 1));
  CHECK(mesh.normals[1] == glm::vec3(0, 0.6f, 0.8f));
  CHECK(mesh.normals[2] == glm::vec3(0, 0, 1));
}

TEST_CASE("parseNff makes cones and cylinders of 64 sides and states the chord error", "[nff]") {
  const NffFile file = parsed("c\n0 0 0 2\n0 0 1 2\nc 0 0 0 1 0 0 1 0\n");
  CHECK(file.parts[0].curved);
  CHECK(onlyParts(file).mesh.triangles.size() == 128 + 64);
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0] ==
        "2 cones and cylinders become meshes of 64 sides (chord error at most 0.00241)");
}

TEST_CASE("parseNff leaves comments out wherever a word may stand", "[nff]") {
  CHECK(onlyParts(parsed("# all\ns 1 2 # centre\n3 # p 3\n4#\n")).spheres.size() == 1);
}

TEST_CASE("parseNff says all faults of a file at their places", "[nff]") {
  CHECK(faultsAfterFill("s 0 0 zero 1\np 2\n0 0 0\n1 0 0\ns 0 0 0 1\nx 1\n") ==
        "a.nff:2:7: found 'zero', expected a sphere's 4 numbers (x y z radius)\n"
        "a.nff:3:3: found '2', expected a number of vertices from 3 to 16384\n"
        "a.nff:7:1: found 'x', expected v, b, l, f, s, c, p, pp or a comment (#)");
}

TEST_CASE("parseNff says what a polygon of a wrong count lacks or has too much", "[nff]") {
  CHECK(faultsAfterFill("p 4\n0 0 0\n1 0 0\n0 1 0\np 3\n0 0 0\n1 0 0\n0 1 0\n") ==
        "a.nff:6:1: found 'p', expected the place of vertex 4 of 4 (x y z)");
  CHECK(faultsAfterFill("p 3\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n") ==
        "a.nff:6:1: found '1', expected v, b, l, f, s, c, p, pp or a comment (#)");
  CHECK(faultsAfterFill("pp 3\n0 0 0\n") ==
        "a.nff:4:1: found the end of the file, expected the normal of vertex 1 of 3 (x y z)");
  for (const char* count : {"1000000000", "-3", "3.5", "0x3", "1e400", "nan"}) {
    INFO(count);
    CHECK(faultsAfterFill(std::string("p ") + count + "\n0 0 0\n1 0 0\n0 1 0\n") ==
          "a.nff:2:3: found '" + std::string(count) +
              "', expected a number of vertices from 3 to 16384");
  }
}

TEST_CASE("parseNff says faults of each entity", "[nff]") {
  CHECK(faultsOf("b 0.1 0.2\n") ==
        "a.nff:2:1: found the end of the file, expected a background's 3 numbers >= 0 (r g b)");
  CHECK(faultsOf("b 0.1 -0.2 0\n") ==
        "a.nff:1:3: found -0.2, expected a background's 3 numbers >= 0 (r g b)");
  CHECK(faultsOf("l 1 2\nb 0 0 0\n") ==
        "a.nff:2:1: found 'b', expected a light's 3 numbers (x y z) or 6 (x y z r g b)");
  CHECK(
      faultsOf("l 1 2 3 red\n") ==
      "a.nff:1:9: found 'red', expected a light's colour (3 numbers >= 0) or the end of the line");
  CHECK(faultsOf("f 1 1 1 1\ns 0 0 0 1\n") ==
        "a.nff:2:1: found 's', expected a fill's 8 numbers (r g b Kd Ks Shine T ior)");
  CHECK(faultsOf("f 1 1 1 -1 0 0 0 0\n") ==
        "a.nff:1:3: found -1 in a fill, expected 8 numbers >= 0 (r g b Kd Ks Shine T ior)");
  CHECK(
      faultsAfterFill("c 0 0 0 1 0 0 1\n") ==
      "a.nff:3:1: found the end of the file, expected a cone's 8 numbers (base, its radius, apex, "
      "its radius)");
  CHECK(
      faultsAfterFill("s 0 0 0 1e19\n") ==
      "a.nff:2:9: found '1e19', expected a number of at most 1e18 in size, whose square fits in a "
      "float");
  CHECK(faultsAfterFill("s 0 inf 0 1\n") ==
        "a.nff:2:5: found 'inf', expected a number of at most 1e18 in size, whose square fits in a "
        "float");
}

TEST_CASE("parseNff wants a fill before surfaces, and says so once", "[nff]") {
  CHECK(faultsOf("s 0 0 0 1\ns 0 0 0 2\n") ==
        "a.nff:1:1: found 's' before the first fill, expected a fill (f) before all surfaces");
}

TEST_CASE("parseNff says faults of the view", "[nff]") {
  const std::string rest = "up 0 1 0\nangle 45\nresolution 8 8\n";
  CHECK(faultsOf("v\nfrom 0 0 1\n" + rest) ==
        "a.nff:1:1: found a view without at, expected all of from, at, up and angle");
  CHECK(faultsOf("v\nfrom 0 0 1\nat 0 0\n" + rest) ==
        "a.nff:4:1: found 'up', expected the 3 numbers of 'at'");
  CHECK(faultsOf("v\nfrom 0 0 1\nat 0 0 1\n" + rest) ==
        "a.nff:1:1: found 'from' and 'at' in the same place, expected two places (at least 1e-18 "
        "apart)");
  CHECK(faultsOf("v\nfrom 0 0 1\nat 0 5 1\n" + rest) ==
        "a.nff:1:1: found an 'up' that is zero or along the view, expected one that is not");
  CHECK(faultsOf("v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 180\n") ==
        "a.nff:1:1: found angle 180, expected an angle above 0 and below 180 degrees");
  CHECK(faultsOf("v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 45\nresolution 1 1\n") ==
        "a.nff:6:12: found '1', expected 2 whole numbers from 2 to 2^28");
  CHECK(faultsOf("v\nfrom 0 0 1\nat 0 0 0\n" + rest + "v\nfrom 0 0 1\nat 0 0 0\n" + rest) ==
        "a.nff:7:1: found a second view, expected only one");
}

TEST_CASE("parseNff survives a file cut off anywhere", "[nff]") {
  const std::string whole =
      "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 45\nresolution 8 8\n"
      "b 1 1 1\nl 1 2 3 1 1 1\n" +
      kFill +
      "s 0 0 0 1\nc\n0 0 0 1\n0 1 0 1\np 3\n0 0 0\n1 0 0\n0 1 0\n"
      "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n";
  REQUIRE(faultsOf(whole) == "");
  int faulty = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    if (faultsOf(whole.substr(0, size)) != "") ++faulty;
  }
  // It is whole between entities alone, and where only digits or optional numbers are cut off.
  CHECK(faulty > 150);
}

TEST_CASE("parseNff cuts a flood of faults short", "[nff]") {
  std::string text;
  for (int i = 0; i < 150; ++i) text += "v x\n";
  const std::string faults = faultsOf(text);
  CHECK(std::count(faults.begin(), faults.end(), '\n') == 100);
  CHECK(faults.ends_with("a.nff: 200 further faults"));
}

TEST_CASE("parseNff counts surfaces without extent, and leaves them out", "[nff]") {
  const NffFile file = parsed(
      "p 3\n0 0 0\n1 1 1\n2 2 2\npp 3\n0 0 0 0 0 1\n0 0 0 0 0 1\n1 0 0 0 0 1\ns 1 1 1 0\n"
      "c 1 1 1 1 1 1 1 1\nc 1 1 1 0 2 2 2 0\ns 0 0 0 1\n");
  CHECK(onlyParts(file).mesh.triangles.empty());
  CHECK(onlyParts(file).spheres.size() == 1);
  CHECK(file.warnings == std::vector<std::string>{"2 polygons without area are left out",
                                                  "1 sphere without extent is left out",
                                                  "2 cones without extent are left out"});
}

TEST_CASE("readNff reads a file, and neither folder nor device", "[nff]") {
  const test::TemporaryDirectory directory;
  test::writeBytes(directory.file("a.nff"), kFill + "s 0 0 0 1\r\n");
  CHECK(readNff(directory.file("a.nff")).parts.size() == 1);
  CHECK_THROWS_AS(readNff(directory.path()), IoError);
  CHECK_THROWS_AS(readNff("/dev/zero"), IoError);
  CHECK_THROWS_AS(readNff(directory.file("b.nff")), IoError);
}
