#include "common/scene/read_content.h"

#include <string>

#include "tests/catch.h"
#include "tests/unit/scene/faults.h"

namespace twintrace {
namespace {

/// Faults of one object of white material; its first own line is line 6.
std::string faultsOfObject(const std::string& lines) {
  return faultsOf(std::string(kWhite) + "[[objects]]\nmaterial = \"white\"\n" + lines);
}

/// Faults of one light; its first own line is line 2.
std::string faultsOfLight(const std::string& lines) {
  return faultsOf("[[lights]]\n" + lines);
}

/// Faults of one material; its first own line is line 2.
std::string faultsOfMaterial(const std::string& lines) {
  return faultsOf("[materials.white]\n" + lines);
}

TEST_CASE("readMaterials reports colours and numbers out of range", "[scene]") {
  CHECK(faultsOfMaterial("albedo = [0.5, -0.1, 0.5]") ==
        "s.toml:2:16: found -0.1, expected a number >= 0");
  CHECK(faultsOfMaterial("emission = [0.5, nan, 0.5]") ==
        "s.toml:2:18: found nan, expected a finite number");
  CHECK(faultsOfMaterial("highlight = [-1, 0, 0]") ==
        "s.toml:2:14: found -1, expected a number >= 0");
  CHECK(faultsOfMaterial("ambient = [-1, 0, 0]") ==
        "s.toml:2:12: found -1, expected a number >= 0");
  CHECK(faultsOfMaterial("exponent = -1.0") == "s.toml:2:12: found -1.0, expected a number >= 0");
  CHECK(faultsOfMaterial("roughness = 1.5") ==
        "s.toml:2:13: found 1.5, expected a number from 0 to 1");
}

TEST_CASE("readMaterials reports unknown lobes and keys", "[scene]") {
  CHECK(faultsOfMaterial("lobe = \"phog\"") ==
        "s.toml:2:8: found 'phog', expected ggx or phong (did you mean 'phong'?)");
  CHECK(faultsOfMaterial("albedo_map = \"a.png\"") ==
        "s.toml:2:1: found key 'albedo_map', expected one of albedo, specular, emission, ambient, "
        "highlight, exponent, roughness or lobe (did you mean 'albedo'?)");
}

TEST_CASE("readMaterials reports lobes that sum above 1", "[scene]") {
  CHECK(faultsOfMaterial("albedo = [0.5, 0.5, 0.5]\nspecular = [0.5, 0.5, 0.75]") ==
        "s.toml:1:12: found albedo + specular = 1.25 in blue of material 'white', expected at most "
        "1 (a surface can't reflect more than it receives)");
  CHECK(faultsOfMaterial("albedo = [1.5, 0, 0]") ==
        "s.toml:1:12: found albedo + specular = 1.5 in red of material 'white', expected at most 1 "
        "(a surface can't reflect more than it receives)");
}

TEST_CASE("readMaterials takes lobes whose decimals sum to 1", "[scene]") {
  for (int i = 0; i <= 1000; ++i) {
    const std::string albedo = std::to_string(i / 1000.0);
    const std::string specular = std::to_string(1 - i / 1000.0);
    INFO(albedo << " + " << specular);
    CHECK(faultsOfMaterial("albedo = [" + albedo + ", 0, 0]\nspecular = [" + specular +
                           ", 0, 0]") == "");
  }
}

TEST_CASE("readObjects reports missing and unknown shapes", "[scene]") {
  const std::string shapes = "expected sphere, box, plane, mesh or generate";
  CHECK(faultsOfObject("") == "s.toml:4:1: found no key 'shape', " + shapes);
  CHECK(faultsOfObject("shape = \"cone\"") == "s.toml:6:9: found 'cone', " + shapes);
  CHECK(faultsOfObject("shape = \"spere\"") ==
        "s.toml:6:9: found 'spere', " + shapes + " (did you mean 'sphere'?)");
}

TEST_CASE("readObjects reports radii that are not positive", "[scene]") {
  const std::string sphere = "shape = \"sphere\"\ncenter = [0, 0, 0]\nradius = ";
  const std::string expected = ", expected a number above 0 (at least 1e-18)";
  CHECK(faultsOfObject(sphere + "0") == "s.toml:8:10: found 0" + expected);
  CHECK(faultsOfObject(sphere + "-1.5") == "s.toml:8:10: found -1.5" + expected);
  CHECK(faultsOfObject(sphere + "1e-40") == "s.toml:8:10: found 1e-40" + expected);
  CHECK(faultsOfObject(sphere + "nan") == "s.toml:8:10: found nan, expected a finite number");
  CHECK(faultsOfObject(sphere + "true") == "s.toml:8:10: found true" + expected);
}

TEST_CASE("readObjects reports missing keys of each shape", "[scene]") {
  CHECK(faultsOfObject("shape = \"sphere\"") ==
        "s.toml:4:1: found no key 'center', expected an array of 3 numbers\n"
        "s.toml:4:1: found no key 'radius', expected a number above 0 (at least 1e-18)");
  CHECK(faultsOfObject("shape = \"box\"") ==
        "s.toml:4:1: found no key 'center', expected an array of 3 numbers\n"
        "s.toml:4:1: found no key 'size', expected an array of 3 numbers");
  CHECK(faultsOfObject("shape = \"plane\"") ==
        "s.toml:4:1: found no key 'point', expected an array of 3 numbers\n"
        "s.toml:4:1: found no key 'normal', expected an array of 3 numbers");
}

TEST_CASE("readObjects reports keys of another shape", "[scene]") {
  CHECK(faultsOfObject("shape = \"box\"\ncenter = [0, 0, 0]\nsize = [1, 1, 1]\nradius = 1") ==
        "s.toml:9:1: found key 'radius', expected one of shape, name, material, center, size, min, "
        "max or rotation");
}

TEST_CASE("readObjects reports boxes without extent", "[scene]") {
  const std::string box = "shape = \"box\"\ncenter = [0, 0, 0]\nsize = ";
  CHECK(faultsOfObject(box + "[1, -1, 1]") == "s.toml:8:12: found -1, expected a number >= 0");
  CHECK(faultsOfObject(box + "[0, 0, 0]") ==
        "s.toml:8:8: found size [0, 0, 0], expected a size above 0 on at least one axis");
  CHECK(faultsOfObject(box + "[1, 0, 1]") == "");
}

TEST_CASE("readObjects reports box corners out of order", "[scene]") {
  const std::string expected =
      "s.toml:8:7: found max below min on an axis, or equal on all, expected max >= min on each "
      "axis, and above it on at least one";
  CHECK(faultsOfObject("shape = \"box\"\nmin = [0, 0, 0]\nmax = [1, -1, 1]") == expected);
  CHECK(faultsOfObject("shape = \"box\"\nmin = [0, 0, 0]\nmax = [0, 0, 0]") == expected);
  CHECK(faultsOfObject("shape = \"box\"\nmin = [0, 0, 0]\nmax = [1, 0, 1]") == "");
}

TEST_CASE("readObjects reports the two ways to give a box when mixed or incomplete", "[scene]") {
  CHECK(faultsOfObject("shape = \"box\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nsize = [1, 1, 1]") ==
        "s.toml:9:1: found 'size' beside 'min' or 'max', expected either 'center' and 'size' or "
        "'min' and 'max'");
  CHECK(faultsOfObject("shape = \"box\"\nmin = [0, 0, 0]") ==
        "s.toml:4:1: found no key 'max', expected an array of 3 numbers");
}

TEST_CASE("readObjects reports mesh files that are missing or not named", "[scene]") {
  CHECK(faultsOfObject("shape = \"mesh\"") ==
        "s.toml:4:1: found no key 'file', expected the name of a mesh file (OBJ, PLY, glTF or NFF)");
  CHECK(faultsOfObject("shape = \"mesh\"\nfile = 3") ==
        "s.toml:7:8: found 3, expected the name of a mesh file (OBJ, PLY, glTF or NFF)");
  const auto none = [](const std::filesystem::path&) { return false; };
  CHECK_THROWS_WITH(
      parseScene(std::string(kWhite) + "[[objects]]\nmaterial = \"white\"\nshape = \"mesh\"\n"
                                       "file = \"a.ply\"",
                 "folder/s.toml", none),
      "folder/s.toml:7:8: found no file 'a.ply', expected a readable mesh file");
}

TEST_CASE("readObjects reports what can't be put in place", "[scene]") {
  for (const std::string shape : {"shape = \"mesh\"\nfile = \"a.ply\"\n",
                                  "shape = \"generate\"\ngenerator = \"tetra\"\nsize = 1\n"}) {
    const std::string line = shape[9] == 'm' ? "s.toml:8:" : "s.toml:9:";
    CHECK(faultsOfObject(shape + "scale = 0") ==
          line + "9: found 0, expected a number above 0 (at least 1e-18)");
    CHECK(faultsOfObject(shape + "scale = [1, 1, 1]") ==
          line + "9: found an array of 3 values, expected a number above 0 (at least 1e-18)");
    CHECK(faultsOfObject(shape + "rotation = 90") ==
          line + "12: found 90, expected an array of 3 numbers");
    CHECK(faultsOfObject(shape + "translation = [0, inf, 0]") ==
          line + "19: found inf, expected a finite number");
  }
}

TEST_CASE("readObjects reports unknown keys of meshes and generators", "[scene]") {
  CHECK(faultsOfObject("shape = \"mesh\"\nfile = \"a.ply\"\nsmooht = true") ==
        "s.toml:8:1: found key 'smooht', expected one of shape, name, material, file, part, scale, "
        "rotation, translation or smooth (did you mean 'smooth'?)");
  CHECK(faultsOfObject("shape = \"mesh\"\nfile = \"a.ply\"\nsmooth = 1") ==
        "s.toml:8:10: found 1, expected true or false");
  CHECK(faultsOfObject("shape = \"generate\"\ngenerator = \"tetra\"\nsize = 1\nsmooth = true") ==
        "s.toml:9:1: found key 'smooth', expected one of shape, name, material, generator, size, "
        "seed, scale, rotation or translation");
}

TEST_CASE("readObjects reports missing and unknown generators", "[scene]") {
  const std::string expected = "expected sphereflake, tetra, mount, tree, spheres, boxes or row";
  CHECK(faultsOfObject("shape = \"generate\"") ==
        "s.toml:4:1: found no key 'generator', " + expected);
  CHECK(faultsOfObject("shape = \"generate\"\ngenerator = \"tetro\"\nsize = 3") ==
        "s.toml:7:13: found 'tetro', " + expected + " (did you mean 'tetra'?)");
}

TEST_CASE("readObjects reports sizes that a generator does not have", "[scene]") {
  const auto fault = [](const std::string& generator, const std::string& size) {
    return faultsOfObject("shape = \"generate\"\ngenerator = \"" + generator +
                          "\"\nsize = " + size);
  };
  CHECK(faultsOfObject("shape = \"generate\"\ngenerator = \"tetra\"") ==
        "s.toml:4:1: found no key 'size', expected an integer from 1 to 11");
  CHECK(fault("sphereflake", "8") == "s.toml:8:8: found 8, expected an integer from 0 to 7");
  CHECK(fault("sphereflake", "-1") == "s.toml:8:8: found -1, expected an integer from 0 to 7");
  CHECK(fault("sphereflake", "2.5") == "s.toml:8:8: found 2.5, expected an integer from 0 to 7");
  CHECK(fault("tetra", "0") == "s.toml:8:8: found 0, expected an integer from 1 to 11");
  CHECK(fault("mount", "12") == "s.toml:8:8: found 12, expected an integer from 1 to 11");
  CHECK(fault("tree", "19") == "s.toml:8:8: found 19, expected an integer from 0 to 18");
  CHECK(fault("row", "9") == "s.toml:8:8: found 9, expected an integer from 0 to 8");
  for (const std::string name : {"spheres", "boxes"}) {
    CHECK(fault(name, "10000001") ==
          "s.toml:8:8: found 10000001, expected an integer from 1 to 10000000");
    CHECK(fault(name, "9223372036854775807") ==
          "s.toml:8:8: found 9223372036854775807, expected an integer from 1 to 10000000");
    CHECK(fault(name, "10000000") == "");
  }
}

TEST_CASE("readObjects reports generators that together make too much", "[scene]") {
  const std::string half =
      "[[objects]]\nmaterial = \"white\"\nshape = \"generate\"\ngenerator = \"spheres\"\n"
      "size = 5000000\n";
  const std::string white(kWhite);
  CHECK(faultsOf(white + half + half) == "");
  CHECK(faultsOf(white + half + half + half + half) ==
        "s.toml:18:8: found 15000000 generated primitives up to here, expected at most 10000000");
}

TEST_CASE("readObjects reports seeds beyond 32 bits", "[scene]") {
  const std::string mount = "shape = \"generate\"\ngenerator = \"mount\"\nsize = 1\nseed = ";
  CHECK(faultsOfObject(mount + "4294967295") == "");
  CHECK(faultsOfObject(mount + "4294967296") ==
        "s.toml:9:8: found 4294967296, expected an integer from 0 to 4294967295");
  CHECK(faultsOfObject(mount + "-1") ==
        "s.toml:9:8: found -1, expected an integer from 0 to 4294967295");
}

TEST_CASE("parseScene keeps what meshes and generators are given", "[scene]") {
  const Scene scene = parseScene(std::string(kWhite) + R"(
[[objects]]
shape = "mesh"
file = "a.ply"
smooth = true
scale = 2.5
rotation = [10, 20, 30]
translation = [1, 2, 3]
material = "white"
[[objects]]
shape = "generate"
generator = "mount"
size = 3
seed = 7
translation = [4, 5, 6]
material = "white"
)",
                                 "folder/s.toml", [](const auto&) { return true; });
  REQUIRE(scene.objects.size() == 2);
  CHECK(scene.objects[0].name == "mesh-0");
  const MeshShape& mesh = std::get<MeshShape>(scene.objects[0].shape);
  CHECK(mesh.file == "folder/a.ply");
  CHECK(mesh.smooth);
  CHECK(mesh.placement.scale == 2.5f);
  CHECK(mesh.placement.rotation == glm::vec3(10.0f, 20.0f, 30.0f));
  CHECK(mesh.placement.translation == glm::vec3(1.0f, 2.0f, 3.0f));
  CHECK(mesh.parts == nullptr);
  const GeneratedShape& generated = std::get<GeneratedShape>(scene.objects[1].shape);
  CHECK(generated.generator == "mount");
  CHECK(generated.size == 3);
  CHECK(generated.seed == 7);
  CHECK(generated.placement.scale == 1.0f);
  CHECK(generated.placement.translation == glm::vec3(4.0f, 5.0f, 6.0f));
  CHECK(generated.parts == nullptr);
}

TEST_CASE("readObjects reports a zero plane normal", "[scene]") {
  CHECK(faultsOfObject("shape = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 1e-30, 0]")
            .ends_with("expected a vector that is not zero (of length at least 1e-18)"));
  CHECK(faultsOfObject("shape = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 0]") ==
        "s.toml:8:10: found [0, 0, 0], expected a vector that is not zero (of length at least "
        "1e-18)");
}

TEST_CASE("readObjects reports missing materials with the nearest one", "[scene]") {
  const std::string sphere = "[[objects]]\nshape = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\n";
  CHECK(faultsOf(std::string(kWhite) + "[materials.blue]\n" + sphere + "material = \"whit\"") ==
        "s.toml:9:12: found material 'whit', expected one of the materials blue or white (did you "
        "mean 'white'?)");
  CHECK(faultsOf(sphere + "material = \"white\"") ==
        "s.toml:5:12: found material 'white', expected a material, of which the file has none "
        "([materials.NAME])");
  CHECK(faultsOf(sphere) == "s.toml:1:1: found no key 'material', expected the name of a material");
  CHECK(faultsOf(sphere + "material = 3") ==
        "s.toml:5:12: found 3, expected the name of a material");
}

TEST_CASE("readObjects reports names given twice, default names included", "[scene]") {
  const std::string sphere =
      "[[objects]]\nshape = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"white\"\n";
  const std::string white(kWhite);
  CHECK(faultsOf(white + sphere + "name = \"a\"\n" + sphere + "name = \"a\"") ==
        "s.toml:15:8: found a second object named 'a' (the first is in line 9), expected a name of "
        "its own");
  CHECK(faultsOf(white + sphere + "name = \"sphere-1\"\n" + sphere) ==
        "s.toml:10:1: found a second object named 'sphere-1' (the first is in line 9), expected a "
        "name of its own");
}

TEST_CASE("readLights reports missing and unknown kinds", "[scene]") {
  CHECK(faultsOfLight("") == "s.toml:1:1: found no key 'kind', expected point, sphere or sun");
  CHECK(faultsOfLight("kind = \"spot\"") ==
        "s.toml:2:8: found 'spot', expected point, sphere or sun");
}

TEST_CASE("readLights reports missing and unknown keys of each kind", "[scene]") {
  CHECK(faultsOfLight("kind = \"point\"\nposition = [0, 0, 0]\npower = [1, 1, 1]") ==
        "s.toml:1:1: found no key 'intensity', expected an array of 3 numbers\n"
        "s.toml:4:1: found key 'power', expected one of kind, position or intensity");
  CHECK(faultsOfLight("kind = \"sphere\"\nposition = [0, 0, 0]\nintensity = [1, 1, 1]") ==
        "s.toml:1:1: found no key 'radius', expected a number above 0 (at least 1e-18)");
  CHECK(faultsOfLight("kind = \"sun\"") ==
        "s.toml:1:1: found no key 'direction', expected an array of 3 numbers\n"
        "s.toml:1:1: found no key 'irradiance', expected an array of 3 numbers");
}

TEST_CASE("readLights reports values out of range", "[scene]") {
  CHECK(faultsOfLight("kind = \"point\"\nposition = [0, 0, 0]\nintensity = [1, -1, 1]") ==
        "s.toml:4:17: found -1, expected a number >= 0");
  const std::string sphere =
      "kind = \"sphere\"\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\nradius = ";
  CHECK(faultsOfLight(sphere + "0") ==
        "s.toml:5:10: found 0, expected a number above 0 (at least 1e-18)");
  const std::string sun = "kind = \"sun\"\nirradiance = [1, 1, 1]\n";
  CHECK(faultsOfLight(sun + "direction = [0, 0, 0]") ==
        "s.toml:4:13: found [0, 0, 0], expected a vector that is not zero (of length at least "
        "1e-18)");
  CHECK(faultsOfLight(sun + "direction = [0, 1, 0]\nangle = 181") ==
        "s.toml:5:9: found 181, expected an angle from 0 to 180 degrees");
}

TEST_CASE("readLights reports more lights than have random dimensions", "[scene]") {
  std::string text;
  const std::string light =
      "[[lights]]\nkind = \"point\"\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\n";
  for (int i = 0; i < 2000; ++i) text += light;
  CHECK(faultsOf(text) == "");
  CHECK(faultsOf(text + light) == "s.toml:8001:1: found 2001 lights, expected at most 2000 lights");
}

}  // namespace
}  // namespace twintrace
