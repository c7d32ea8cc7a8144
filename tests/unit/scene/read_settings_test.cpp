#include "common/scene/read_settings.h"

#include <filesystem>
#include <string>

#include "tests/catch.h"
#include "tests/unit/scene/faults.h"

namespace twintrace {
namespace {

TEST_CASE("readFilmAndRender reports sizes of the film out of range", "[scene]") {
  const std::string expected = ", expected an integer from 1 to 268435456";
  CHECK(faultsOf("[film]\nwidth = 0") == "s.toml:2:9: found 0" + expected);
  CHECK(faultsOf("[film]\nheight = -1") == "s.toml:2:10: found -1" + expected);
  CHECK(faultsOf("[film]\nwidth = 4294967296") == "s.toml:2:9: found 4294967296" + expected);
  CHECK(faultsOf("[film]\nwidth = 64.0") == "s.toml:2:9: found 64.0" + expected);
  CHECK(faultsOf("[film]\nwidth = \"64\"") == "s.toml:2:9: found '64'" + expected);
}

TEST_CASE("readFilmAndRender reports a film of more than 2^28 pixels", "[scene]") {
  CHECK(faultsOf("[film]\nwidth = 16384\nheight = 16384") == "");
  CHECK(faultsOf("[film]\nwidth = 16384\nheight = 16385") ==
        "s.toml:1:2: found a film of 16384 x 16385 pixels, expected at most 268435456 pixels");
}

TEST_CASE("readFilmAndRender keeps the film's size out of [render]", "[scene]") {
  CHECK(faultsOf("[render]\nwidth = 8")
            .starts_with("s.toml:2:1: found key 'width', expected one "
                         "of backend, spp, passes,"));
  CHECK(faultsOf("[film]\nwidht = 8") ==
        "s.toml:2:1: found key 'widht', expected one of width or height (did you mean 'width'?)");
}

TEST_CASE("readFilmAndRender reports integers of [render] out of range", "[scene]") {
  CHECK(faultsOf("[render]\nspp = 0") ==
        "s.toml:2:7: found 0, expected an integer from 1 to 1073741824");
  CHECK(faultsOf("[render]\npasses = 4097") ==
        "s.toml:2:10: found 4097, expected an integer from 1 to 4096");
  CHECK(faultsOf("[render]\nbounces = 1025") ==
        "s.toml:2:11: found 1025, expected an integer from 0 to 1024");
  CHECK(faultsOf("[render]\nseed = 4294967296") ==
        "s.toml:2:8: found 4294967296, expected an integer from 0 to 4294967295");
  CHECK(faultsOf("[render]\nthreads = 5000") ==
        "s.toml:2:11: found 5000, expected an integer from 0 to 4096");
  CHECK(faultsOf("[render]\nbounces = 0\nspp = 1\npasses = 4096\nseed = 0") == "");
}

TEST_CASE("readFilmAndRender reports times and errors out of range", "[scene]") {
  CHECK(faultsOf("[render]\ntime = nan") ==
        "s.toml:2:8: found nan, expected seconds from 0 (no limit) to 1e9");
  CHECK(faultsOf("[render]\ntarget-error = -0.1") ==
        "s.toml:2:16: found -0.1, expected a relative error from 0 (none) to 1");
  CHECK(faultsOf("[render]\ntime = 2") == "");
}

TEST_CASE("readFilmAndRender reports a first sample inside a frame", "[scene]") {
  CHECK(faultsOf("[render]\npasses = 2\nfirst-sample = 3") ==
        "s.toml:1:2: found first-sample 3 with passes 2, expected a multiple of passes");
}

TEST_CASE("readFilmAndRender reports unknown words with the nearest known one", "[scene]") {
  CHECK(faultsOf("[render]\nintegrator = \"paht\"") ==
        "s.toml:2:14: found 'paht', expected path, report, whitted or local (did you mean "
        "'path'?)");
  CHECK(faultsOf("[render]\nnoise = \"sobol\"") ==
        "s.toml:2:9: found 'sobol', expected pcg or sine");
  CHECK(faultsOf("[render]\nmaths = 3") == "s.toml:2:9: found 3, expected strict or native");
  const std::string hull = faultsOf("[render]\nhull = \"kdop\"");
  CHECK_THAT(hull, Catch::StartsWith("s.toml:2:8: found 'kdop', expected auto, none, ") &&
                       Catch::Contains(" or embree (did you mean 'kdop6'?)"));
}

TEST_CASE("readFilmAndRender reports unknown effects in a list", "[scene]") {
  CHECK(faultsOf("[render]\neffects = \"box,difuse\"") ==
        "s.toml:2:11: found 'box,difuse', expected auto, all or a comma-separated list of sphere, "
        "box, orientedBox, triangle, smooth, plane, emission, diffuse, mirror, ggx, phong, "
        "environmentImage, pointLight, sphereLight, sunLight, lens or indirect");
}

TEST_CASE("readFilmAndRender lets the integrator imply the intersector unless given", "[scene]") {
  const auto intersectorOf = [](const std::string& lines) {
    return parseScene("[render]\n" + lines, "s.toml").render.intersector;
  };
  CHECK(intersectorOf("integrator = \"report\"") == Intersector::report);
  CHECK(intersectorOf("integrator = \"path\"") == Intersector::robust);
  CHECK(intersectorOf("intersector = \"robust\"\nintegrator = \"report\"") == Intersector::robust);
}

TEST_CASE("readCamera reports angles, apertures and focus out of range", "[scene]") {
  const std::string angle = ", expected an angle above 0 and below 180 degrees";
  CHECK(faultsOf("[camera]\nfov = 0") == "s.toml:2:7: found 0" + angle);
  CHECK(faultsOf("[camera]\nfov = 180.0") == "s.toml:2:7: found 180.0" + angle);
  CHECK(faultsOf("[camera]\nfov = 179.9999999999") == "s.toml:2:7: found 179.9999999999" + angle);
  CHECK(faultsOf("[camera]\nfov = \"wide\"") == "s.toml:2:7: found 'wide'" + angle);
  CHECK(faultsOf("[camera]\naperture = -0.5") == "s.toml:2:12: found -0.5, expected a number >= 0");
  CHECK(faultsOf("[camera]\nfocus = 0") ==
        "s.toml:2:9: found 0, expected a number above 0 (at least 1e-18)");
}

TEST_CASE("readCamera reports NaN, infinity and numbers too large", "[scene]") {
  CHECK(faultsOf("[camera]\neye = [nan, 0, inf]") ==
        "s.toml:2:8: found nan, expected a finite number\n"
        "s.toml:2:16: found inf, expected a finite number");
  const std::string expected =
      ", expected a number of at most 1e18 in size, whose square fits in a float";
  CHECK(faultsOf("[camera]\neye = [0, 0, -2e18]") == "s.toml:2:14: found -2e+18" + expected);
  CHECK(faultsOf("[camera]\nfov = 1e300") == "s.toml:2:7: found 1e+300" + expected);
  CHECK(faultsOf("[camera]\neye = [0, 0, 1e18]\nfov = 1") == "");
}

TEST_CASE("readCamera reports vectors of the wrong shape", "[scene]") {
  const std::string expected = ", expected an array of 3 numbers";
  CHECK(faultsOf("[camera]\neye = [1, 2]") == "s.toml:2:7: found an array of 2 values" + expected);
  CHECK(faultsOf("[camera]\neye = [1]") == "s.toml:2:7: found an array of 1 value" + expected);
  CHECK(faultsOf("[camera]\neye = 1.5") == "s.toml:2:7: found 1.5" + expected);
  CHECK(faultsOf("[camera]\neye = {x = 1}") == "s.toml:2:7: found a table" + expected);
  CHECK(faultsOf("[camera]\neye = 1979-05-27") == "s.toml:2:7: found a date or time" + expected);
  CHECK(faultsOf("[camera]\neye = [1, \"2\", 3]") == "s.toml:2:11: found '2', expected a number");
}

TEST_CASE("readCamera reports a view without direction or orientation", "[scene]") {
  CHECK(faultsOf("[camera]\neye = [1, 2, 3]\ntarget = [1, 2, 3]") ==
        "s.toml:3:10: found a target equal to eye, expected a target that is not eye (at least "
        "1e-18 away)");
  CHECK(faultsOf("[camera]\nup = [0, 0, 0]") ==
        "s.toml:2:6: found [0, 0, 0], expected a vector that is not zero (of length at least "
        "1e-18)");
  const std::string parallel =
      "found up parallel to the view (from eye to target), expected an up that is not parallel to "
      "it";
  CHECK(faultsOf("[camera]\nup = [0, 0, -2]") == "s.toml:2:6: " + parallel);
  CHECK(faultsOf("[camera]\neye = [0, 5, 0]\ntarget = [0, 0, 0]") == "s.toml:3:10: " + parallel);
}

TEST_CASE("readCamera reports a focal plane whose size would overflow", "[scene]") {
  CHECK(faultsOf("[camera]\nfov = 90\nfocus = 1e18") ==
        "s.toml:2:7: found a picture 2e+18 by 2e+18 units large at the focus distance, expected at "
        "most 1e18 (a smaller fov, a nearer target or focus)");
}

TEST_CASE("readEnvironment reports a missing image at its place", "[scene]") {
  const auto none = [](const std::filesystem::path&) { return false; };
  CHECK_THROWS_WITH(parseScene("[environment]\nimage = \"sky.exr\"", "folder/s.toml", none),
                    "folder/s.toml:2:9: found no file 'sky.exr', expected a readable image file");
}

TEST_CASE("readEnvironment resolves the image against the scene file", "[scene]") {
  std::filesystem::path asked;
  const auto check = [&](const std::filesystem::path& path) {
    asked = path;
    return true;
  };
  const std::string text = "[environment]\nimage = \"sky.exr\"";
  CHECK(parseScene(text, "folder/s.toml", check).environment.image == "folder/sky.exr");
  CHECK(asked == "folder/sky.exr");
  CHECK(parseScene(text, "s.toml", check).environment.image == "sky.exr");
}

TEST_CASE("readEnvironment reports radiance beside an image", "[scene]") {
  CHECK(faultsOf("[environment]\nradiance = [1, 1, 1]\nimage = \"sky.exr\"") ==
        "s.toml:3:1: found both 'radiance' and 'image', expected only one of them");
}

TEST_CASE("readEnvironment reports what only an image has", "[scene]") {
  CHECK(faultsOf("[environment]\nstrength = 2\nrotation = 90") ==
        "s.toml:2:1: found 'strength' without 'image', expected it only beside 'image'\n"
        "s.toml:3:1: found 'rotation' without 'image', expected it only beside 'image'");
}

TEST_CASE("readEnvironment reports values out of range", "[scene]") {
  CHECK(faultsOf("[environment]\nradiance = [0, -1, 0]") ==
        "s.toml:2:16: found -1, expected a number >= 0");
  CHECK(faultsOf("[environment]\nimage = \"a\"\nstrength = -1") ==
        "s.toml:3:12: found -1, expected a number >= 0");
  CHECK(faultsOf("[environment]\nimage = \"a\\u0000b\"") ==
        "s.toml:2:9: found 'a\\x00b', expected the name of an image file");
}

TEST_CASE("readEffects reports unknown names and values that are not bool", "[scene]") {
  CHECK(faultsOf("[effects]\nindirekt = true") ==
        "s.toml:2:1: found key 'indirekt', expected one of sphere, box, orientedBox, triangle, "
        "smooth, plane, emission, diffuse, mirror, ggx, phong, environmentImage, pointLight, "
        "sphereLight, sunLight, lens or indirect (did you mean 'indirect'?)");
  CHECK(faultsOf("[effects]\nlens = 1") == "s.toml:2:8: found 1, expected true or false");
}

}  // namespace
}  // namespace twintrace
