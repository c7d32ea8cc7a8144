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
  CHECK(faultsOfObject("") == "s.toml:4:1: found no key 'shape', expected sphere, box or plane");
  CHECK(faultsOfObject("shape = \"mesh\"\nfile = \"a.ply\"") ==
        "s.toml:6:9: found 'mesh', expected sphere, box or plane");
  CHECK(faultsOfObject("shape = \"spere\"") ==
        "s.toml:6:9: found 'spere', expected sphere, box or plane (did you mean 'sphere'?)");
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
