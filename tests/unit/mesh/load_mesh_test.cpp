#include "common/mesh/load_mesh.h"

#include <filesystem>
#include <glm/geometric.hpp>

#include "tests/catch.h"
#include "tests/unit/mesh/mesh_files.h"

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using twintrace::test::faultOf;
using twintrace::test::gltfText;
using twintrace::test::loadText;
using twintrace::test::plyText;

namespace twintrace {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
const std::string kVertices = "0 0 0\n1 0 0\n1 1 0\n";
const std::string kTriangleBuffer = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAABAAIAAAA=";
const std::string kIndex9Buffer = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAABAAkAAAA=";
const std::string kNanBuffer = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAwH8AAAAAAAABAAIAAAA=";

/// Corners of a mesh's triangles in place.
std::vector<glm::vec3> cornersOf(const Mesh& mesh) {
  std::vector<glm::vec3> corners;
  for (const Corners& triangle : mesh.triangles) {
    for (const std::uint32_t i : triangle) corners.push_back(mesh.positions[i]);
  }
  return corners;
}

const std::vector<glm::vec3> kTriangleCorners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};

TEST_CASE("loadMesh reads the same triangle from OBJ, PLY and glTF", "[mesh]") {
  CHECK(cornersOf(loadText("a.obj", kTriangle).mesh) == kTriangleCorners);
  CHECK(cornersOf(loadText("a.OBJ", kTriangle).mesh) == kTriangleCorners);
  CHECK(cornersOf(loadText("a.ply", plyText(3, 1, kVertices + "3 0 1 2\n")).mesh) ==
        kTriangleCorners);
  CHECK(cornersOf(loadText("a.gltf", gltfText(kTriangleBuffer)).mesh) == kTriangleCorners);
}

TEST_CASE("loadMesh puts what a glTF file moves in place", "[mesh]") {
  const LoadedMesh loaded = loadText(
      "a.gltf",
      gltfText(kTriangleBuffer, R"({"mesh": 0, "translation": [0, 0, 5], "scale": [2, 2, 2]})"));
  CHECK(cornersOf(loaded.mesh) == std::vector<glm::vec3>{{0, 0, 5}, {2, 0, 5}, {2, 2, 5}});
}

TEST_CASE("loadMesh cuts up polygons, concave ones too", "[mesh]") {
  const Mesh quad = loadText("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").mesh;
  CHECK(quad.positions.size() == 4);
  CHECK(quad.triangles.size() == 2);
  // An arrowhead, whose diagonal from 1 to 3 lies outside.
  const Mesh arrow = loadText("a.obj", "v 0 2 0\nv -2 -1 0\nv 0 0 0\nv 2 -1 0\nf 2 3 4 1\n").mesh;
  double area = 0.0;
  for (const Corners& c : arrow.triangles) {
    area += 0.5 * glm::length(glm::cross(arrow.positions[c[1]] - arrow.positions[c[0]],
                                         arrow.positions[c[2]] - arrow.positions[c[0]]));
  }
  CHECK(area == Approx(4.0));
}

TEST_CASE("loadMesh joins all groups of a file and vertices at the same place", "[mesh]") {
  const Mesh mesh = loadText("a.obj",
                             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\nv 1 1 0\n"
                             "g a\nf 1 2 3\nf 5 6 4\ng b\nf 1 3 4\n")
                        .mesh;
  CHECK(mesh.triangles.size() == 3);
  CHECK(mesh.positions.size() == 4);
}

TEST_CASE("loadMesh leaves out points and lines beside triangles", "[mesh]") {
  CHECK(cornersOf(loadText("a.obj", kTriangle + "l 1 2\np 3\n").mesh) == kTriangleCorners);
}

TEST_CASE("loadMesh keeps texture coordinates", "[mesh]") {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.25 0.5\nvt 0.75 0.5\nvt 1 0.125\nf 1/1 2/2 3/3\n";
  const Mesh mesh = loadText("a.obj", text).mesh;
  REQUIRE(mesh.textureCoordinates.size() == 3);
  const Corners& c = mesh.triangles[0];
  CHECK(mesh.textureCoordinates[c[0]] == glm::vec2(0.25f, 0.5f));
  CHECK(mesh.textureCoordinates[c[1]] == glm::vec2(0.75f, 0.5f));
  CHECK(mesh.textureCoordinates[c[2]] == glm::vec2(1.0f, 0.125f));
  CHECK(loadText("a.obj", kTriangle).mesh.textureCoordinates.empty());
}

TEST_CASE("loadMesh takes the file's normals for smooth shading, as unit vectors", "[mesh]") {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 3 4\nvn 1 0 0\nvn 0 0 0\nf 1//1 2//2 3//3\n";
  const Mesh mesh = loadText("a.obj", text, true).mesh;
  REQUIRE(mesh.normals.size() == 3);
  const Corners& c = mesh.triangles[0];
  CHECK(mesh.normals[c[0]].y == Approx(0.6));
  CHECK(mesh.normals[c[0]].z == Approx(0.8));
  CHECK(mesh.normals[c[1]] == glm::vec3(1, 0, 0));
  // No direction: the triangle's own normal.
  CHECK(mesh.normals[c[2]] == glm::vec3(0, 0, 1));
}

TEST_CASE("loadMesh makes normals for smooth shading where the file has none", "[mesh]") {
  const Mesh mesh = loadText("a.obj", kTriangle, true).mesh;
  CHECK(mesh.normals == std::vector<glm::vec3>(3, {0, 0, 1}));
}

TEST_CASE("loadMesh leaves normals out for flat shading", "[mesh]") {
  const std::string normals = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 1 0\nf 1//1 2//1 3//1\n";
  CHECK(loadText("a.obj", normals, false).mesh.normals.empty());
}

TEST_CASE("loadMesh leaves out triangles without area and counts them", "[mesh]") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\n";
  const LoadedMesh loaded = loadText("a.obj", vertices + "f 1 2 3\nf 1 2 4\nf 1 1 4\n");
  CHECK(loaded.mesh.triangles.size() == 1);
  CHECK(loaded.warnings == std::vector<std::string>{"2 triangles without area are left out"});
  CHECK(loadText("a.obj", vertices + "f 1 2 3\nf 1 2 4\n").warnings ==
        std::vector<std::string>{"1 triangle without area is left out"});
  CHECK(loadText("a.obj", kTriangle).warnings.empty());
}

TEST_CASE("loadMesh rejects files without any triangle", "[mesh]") {
  const std::string expected = "found no triangle in 'a.obj', expected at least one";
  CHECK(faultOf("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\n") == expected);
  CHECK(faultOf("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2\np 1\n") == expected);
  CHECK(faultOf("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n") == expected);
  CHECK(faultOf("a.ply", plyText(3, 0, kVertices)) ==
        "found no triangle in 'a.ply', expected at least one");
}

TEST_CASE("loadMesh rejects coordinates that are not finite or too large", "[mesh]") {
  const std::string rest =
      " with coordinates that are not finite or beyond 1e18, expected finite ones";
  const auto obj = [](const std::string& x) {
    return faultOf("a.obj", "v 0 0 0\nv 1 0 0\nv " + x + " 1 0\nf 1 2 3\n");
  };
  CHECK(obj("nan") == "found 1 vertex in 'a.obj'" + rest);
  CHECK(obj("inf") == "found 1 vertex in 'a.obj'" + rest);
  CHECK(obj("1e19") == "found 1 vertex in 'a.obj'" + rest);
  CHECK(obj("9e17") == "");
  CHECK(faultOf("a.ply", plyText(3, 1, "nan 0 0\n1 nan 0\n1 1 0\n3 0 1 2\n")) ==
        "found 2 vertices in 'a.ply'" + rest);
  CHECK(faultOf("a.gltf", gltfText(kNanBuffer)) == "found 1 vertex in 'a.gltf'" + rest);
  CHECK(faultOf("a.gltf", gltfText(kTriangleBuffer, R"({"mesh": 0, "scale": [1e30, 1, 1]})")) ==
        "found 2 vertices in 'a.gltf'" + rest);
}

TEST_CASE("loadMesh rejects indices of vertices that are not there", "[mesh]") {
  const std::string ply =
      "found 1 face in 'a.ply' without vertices or with some that are not there, expected indices "
      "of vertices that are";
  CHECK(faultOf("a.ply", plyText(3, 2, kVertices + "3 0 1 2\n3 0 1 7\n")) == ply);
  CHECK(faultOf("a.ply", plyText(3, 2, kVertices + "3 0 1 2\n3 0 1 -1\n")) == ply);
  CHECK(faultOf("a.ply", plyText(3, 2, kVertices + "3 0 1 2\n0\n")) == ply);
  CHECK(faultOf("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n") ==
        "found mesh file 'a.obj' that can't be read (OBJ: vertex index out of range), expected a "
        "sound one");
  CHECK_THAT(faultOf("a.gltf", gltfText(kIndex9Buffer)),
             StartsWith("found mesh file 'a.gltf' that can't be read ("));
}

TEST_CASE("loadMesh rejects files that are cut off", "[mesh]") {
  const std::string ply = plyText(3, 1, kVertices + "3 0 1 2\n");
  for (std::size_t length = 0; length + 2 < ply.size(); length += 7) {
    INFO(ply.substr(0, length));
    CHECK_THAT(faultOf("a.ply", ply.substr(0, length)), StartsWith("found "));
  }
  const std::string gltf = gltfText(kTriangleBuffer);
  for (std::size_t length = 0; length + 2 < gltf.size(); length += 31) {
    INFO(gltf.substr(0, length));
    CHECK_THAT(faultOf("a.gltf", gltf.substr(0, length)), StartsWith("found "));
  }
  CHECK_THAT(faultOf("a.obj", kTriangle.substr(0, kTriangle.size() - 6)), StartsWith("found "));
}

TEST_CASE("loadMesh rejects files of other content", "[mesh]") {
  std::string rubbish;
  for (int i = 0; i < 4096; ++i) rubbish += static_cast<char>(i * i * 7 + i / 3);
  for (const std::string name : {"a.obj", "a.ply", "a.gltf", "a.glb"}) {
    INFO(name);
    CHECK_THAT(faultOf(name, rubbish), StartsWith("found "));
    CHECK_THAT(faultOf(name, ""), StartsWith("found "));
  }
}

TEST_CASE("loadMesh rejects folders and files that are not there", "[mesh]") {
  const test::TemporaryDirectory directory;
  for (const std::string name : {"a.obj", "a.ply", "a.gltf"}) {
    INFO(name);
    CHECK_THROWS_AS(loadMesh(directory.file(name), false), MeshError);
    std::filesystem::create_directory(directory.file(name));
    CHECK_THROWS_AS(loadMesh(directory.file(name), false), MeshError);
  }
}

TEST_CASE("loadMesh rejects other endings", "[mesh]") {
  CHECK(faultOf("a.stl", "") ==
        "found mesh file 'a.stl', expected one that ends in .obj, .ply, .gltf, .glb or .nff");
  CHECK_THAT(faultOf("obj", ""), Contains("expected one that ends in"));
}

}  // namespace
}  // namespace twintrace
