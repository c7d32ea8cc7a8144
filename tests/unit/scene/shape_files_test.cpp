#include "common/scene/shape_files.h"

#include "common/base/error.h"
#include "common/mesh/triangulate.h"
#include "common/scene/reader.h"
#include "tests/catch.h"
#include "tests/unit/experiments/temporary_directory.h"
#include "tests/unit/scene/faults.h"

using namespace twintrace;

namespace {

const std::string kNff =
    "f 1 0 0 1 0 0 0 0\ns 0 0 0 1\np 3\n0 0 0\n1 0 0\n0 1 0\n"
    "f 0 1 0 1 0 0 0 0\ns 5 0 0 1\ns 6 0 0 1\n";
const std::string kObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nmtllib a.mtl\nusemtl a\nf 1 2 3\n"
    "usemtl b\nf 1 2 4\nf 2 3 4\n";

/// A folder with both files.
class Files {
 public:
  Files() {
    test::writeBytes(directory_.file("a.nff"), kNff);
    test::writeBytes(directory_.file("a.obj"), kObj);
    test::writeBytes(directory_.file("a.mtl"), "newmtl a\nnewmtl b\n");
  }

  Parts load(const std::string& name, std::optional<int> part, bool smooth = false) {
    MeshShape shape;
    shape.file = directory_.file(name);
    shape.part = part;
    shape.smooth = smooth;
    return files_.load(shape, warnings_);
  }

  std::string path(const std::string& name) const { return directory_.file(name); }
  void write(const std::string& name, const std::string& text) {
    test::writeBytes(directory_.file(name), text);
  }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  test::TemporaryDirectory directory_;
  ShapeFiles files_;
  std::vector<std::string> warnings_;
};

}  // namespace

TEST_CASE("ShapeFiles loads an NFF file's fills each or all", "[scene]") {
  Files files;
  CHECK(files.load("a.nff", 0).spheres.size() == 1);
  CHECK(files.load("a.nff", 0).mesh.triangles.size() == 1);
  CHECK(files.load("a.nff", 1).spheres.size() == 2);
  CHECK(files.load("a.nff", 1).mesh.triangles.empty());
  CHECK(files.load("a.nff", std::nullopt).spheres.size() == 3);
}

TEST_CASE("ShapeFiles gives an NFF file's triangles normals only if they are asked for",
          "[scene]") {
  Files files;
  CHECK(files.load("a.nff", 0, false).mesh.normals.empty());
  CHECK(files.load("a.nff", 0, true).mesh.normals.size() == 3);
}

TEST_CASE("ShapeFiles loads an OBJ's materials each or all", "[scene]") {
  Files files;
  std::vector<std::size_t> counts;
  for (int part = 0; part < 3; ++part) {
    try {
      counts.push_back(files.load("a.obj", part).mesh.triangles.size());
    } catch (const MeshError&) {
      // assimp puts a default material first.
    }
  }
  CHECK(counts == std::vector<std::size_t>{1, 2});
  CHECK(files.load("a.obj", std::nullopt).mesh.triangles.size() == 3);
}

TEST_CASE("ShapeFiles reads a file once, and its warnings come once", "[scene]") {
  Files files;
  files.write("b.nff", kNff + "s 0 0 0 0\n");
  files.load("b.nff", 0);
  files.write("b.nff", "broken");
  CHECK(files.load("b.nff", 1).spheres.size() == 2);
  CHECK(files.warnings() ==
        std::vector<std::string>{files.path("b.nff") + ": 1 sphere without extent is left out"});
}

TEST_CASE("ShapeFiles cuts up concave polygons of an OBJ", "[scene]") {
  Files files;
  files.write("b.obj", "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\nf 4 3 2 2\n");
  const Mesh mesh = files.load("b.obj", std::nullopt).mesh;
  double area = 0.0;
  for (const Corners& c : mesh.triangles) {
    const std::vector<glm::vec3> corners = {mesh.positions[c[0]], mesh.positions[c[1]],
                                            mesh.positions[c[2]]};
    area += areaVector(corners).z;
  }
  // Each has 4; the second fills the first's notch.
  CHECK(area == Approx(8.0));
}

TEST_CASE("ShapeFiles says which parts there are", "[scene]") {
  Files files;
  CHECK_THROWS_WITH(files.load("a.nff", 2), "found part 2 of '" + files.path("a.nff") +
                                                "', which has 2 parts, expected a number below 2");
  CHECK_THROWS_AS(files.load("a.obj", 9), MeshError);
}

TEST_CASE("A scene names the faults within its NFF file", "[scene]") {
  Files files;
  files.write("b.nff", "s 0 0 0 1\n");
  files.write("s.toml",
              std::string(kWhite) +
                  "[[objects]]\nshape = \"mesh\"\nfile = \"b.nff\"\nmaterial = \"white\"\n"
                  "[[objects]]\nshape = \"mesh\"\nfile = \"b.nff\"\nmaterial = \"white\"\n");
  CHECK_THROWS_WITH(readScene(files.path("s.toml")),
                    files.path("b.nff") +
                        ":1:1: found 's' before the first fill, expected a fill (f) before all "
                        "surfaces\n" +
                        files.path("s.toml") + ":8:1: found faulty mesh file '" +
                        files.path("b.nff") + "' again, expected a sound one");
}

TEST_CASE("A mesh's part is a number from 0", "[scene]") {
  CHECK(faultsOf(std::string(kWhite) + "[[objects]]\nshape = \"mesh\"\nfile = \"a.nff\"\n"
                                       "material = \"white\"\npart = -1\n") ==
        "s.toml:8:8: found -1, expected an integer from 0 to 2147483647");
}
