#include "common/scene/reader.h"

#include <filesystem>
#include <string>

#include "tests/catch.h"
#include "tests/unit/scene/faults.h"

namespace twintrace {
namespace {

std::filesystem::path fixture(const std::string& name) {
  return std::filesystem::path(TWINTRACE_TEST_DATA) / "scene/fixtures" / name;
}

/// What reading a fixture throws, with the folder taken out of the message.
std::string faultsOfFixture(const std::string& name) {
  const std::string path = fixture(name).string();
  try {
    readScene(path);
    return "";
  } catch (const FileError& error) {
    std::string text = error.what();
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path)) {
      text.replace(at, path.size(), name);
    }
    return text;
  }
}

TEST_CASE("readScene reads film, camera and environment", "[scene]") {
  const Scene scene = readScene(fixture("full.toml"));
  CHECK(scene.name == "full");
  CHECK(scene.path == fixture("full.toml").string());
  CHECK(scene.render.width == 320);
  CHECK(scene.render.height == 200);
  CHECK(scene.camera.eye == glm::vec3(0.0f, 1.0f, 3.9f));
  CHECK(scene.camera.target == glm::vec3(0.0f, 1.0f, 0.0f));
  CHECK(scene.camera.up == glm::vec3(0.0f, 2.0f, 0.0f));
  CHECK(scene.camera.fov == 35.0f);
  CHECK(scene.camera.aperture == 0.1f);
  CHECK(scene.camera.focus == 3.5f);
  CHECK(scene.environment.image == fixture("sky.exr").string());
  CHECK(scene.environment.strength == 0.5f);
  CHECK(scene.environment.rotation == 90.0f);
}

TEST_CASE("readScene reads every option of [render]", "[scene]") {
  const RenderOptions render = readScene(fixture("full.toml")).render;
  CHECK(render.backend == BackEnd::gpu);
  CHECK(render.integrator == Integrator::report);
  CHECK(render.spp == 24);
  CHECK(render.passes == 4);
  CHECK(render.bounces == 3);
  CHECK(render.noise == Noise::sine);
  CHECK(render.maths == Maths::native);
  CHECK(render.precision == Precision::float64);
  CHECK(render.lanes == Lanes::scalar);
  CHECK(render.lanesGiven);
  CHECK(render.intersector == Intersector::robust);
  CHECK(render.hull == "none");
  CHECK(render.geometry == Geometry::buffer);
  CHECK(render.provider == Provider::egl);
  CHECK(render.stage == Stage::compute);
  CHECK(render.threads == 3);
  CHECK(render.effects == "sphere,diffuse");
  CHECK(render.seed == 4294967295u);
  CHECK(render.firstSample == 8);
  CHECK(render.timeLimit == 1.5);
  CHECK(render.targetError == 0.01);
}

TEST_CASE("readScene reads materials in the order of their names", "[scene]") {
  const std::vector<Material> materials = readScene(fixture("full.toml")).materials;
  REQUIRE(materials.size() == 3);
  CHECK(materials[0].name == "glossy");
  CHECK(materials[0].albedo == glm::vec3(0.1f, 0.3f, 0.7f));
  CHECK(materials[0].specular == glm::vec3(0.9f, 0.7f, 0.3f));
  CHECK(materials[0].roughness == 0.25f);
  CHECK(materials[0].lobe == Lobe::phong);
  CHECK(materials[1].name == "lamp");
  CHECK(materials[1].emission == glm::vec3(17.0f, 12.0f, 4.0f));
  CHECK(materials[1].lobe == Lobe::ggx);
  CHECK(materials[2].name == "white");
  CHECK(materials[2].albedo == glm::vec3(0.73f, 0.63f, 0.53f));
  CHECK(materials[2].ambient == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(materials[2].highlight == glm::vec3(0.5f, 0.4f, 0.3f));
  CHECK(materials[2].exponent == 32.0f);
}

TEST_CASE("readScene reads objects of every shape and names those without a name", "[scene]") {
  const std::vector<Object> objects = readScene(fixture("full.toml")).objects;
  REQUIRE(objects.size() == 4);
  CHECK(objects[0].name == "ball");
  CHECK(objects[0].material == 2);
  CHECK(std::get<SphereShape>(objects[0].shape).center == glm::vec3(0.4f, 0.35f, 0.3f));
  CHECK(std::get<SphereShape>(objects[0].shape).radius == 0.35f);
  CHECK(objects[1].name == "box-1");
  CHECK(objects[1].material == 0);
  CHECK(std::get<BoxShape>(objects[1].shape).size == glm::dvec3(2.0f, 0.0f, 2.0f));
  CHECK(std::get<BoxShape>(objects[1].shape).rotation == glm::vec3(0.0f, 30.0f, 0.0f));
  CHECK(objects[2].material == 1);
  CHECK(std::get<BoxShape>(objects[2].shape).center == glm::dvec3(0.0f, 1.75f, 1.0f));
  CHECK(std::get<BoxShape>(objects[2].shape).size == glm::dvec3(2.0f, 0.5f, 4.0f));
  CHECK_FALSE(std::get<BoxShape>(objects[2].shape).rotation);
  CHECK(objects[3].name == "plane-3");
  CHECK(std::get<PlaneShape>(objects[3].shape).point == glm::vec3(0.0f, -1.0f, 0.0f));
  CHECK(std::get<PlaneShape>(objects[3].shape).normal == glm::vec3(0.0f, 3.0f, 4.0f));
}

TEST_CASE("readScene reads lights of every kind and forced effects", "[scene]") {
  const Scene scene = readScene(fixture("full.toml"));
  REQUIRE(scene.lights.size() == 3);
  CHECK(std::get<PointLight>(scene.lights[0]).position == glm::vec3(0.0f, 1.9f, 0.0f));
  CHECK(std::get<PointLight>(scene.lights[0]).intensity == glm::vec3(1.0f, 2.0f, 3.0f));
  CHECK(std::get<SphereLight>(scene.lights[1]).radius == 0.5f);
  CHECK(std::get<SphereLight>(scene.lights[1]).intensity == glm::vec3(4.0f, 5.0f, 6.0f));
  CHECK(std::get<SunLight>(scene.lights[2]).direction == glm::vec3(1.0f, -1.0f, 0.0f));
  CHECK(std::get<SunLight>(scene.lights[2]).irradiance == glm::vec3(7.0f, 8.0f, 9.0f));
  CHECK(std::get<SunLight>(scene.lights[2]).angle == 0.53f);
  CHECK(scene.forcedEffects == std::map<std::string, bool>{{"indirect", false}, {"plane", true}});
}

TEST_CASE("parseScene fills an empty file with defaults and the file's name", "[scene]") {
  const Scene scene = parseScene("", "folder/empty.toml");
  CHECK(scene.name == "empty");
  CHECK(scene.render.width == 512);
  CHECK(scene.camera.fov == 40.0f);
  CHECK(scene.environment.radiance == glm::vec3(0.0f));
  CHECK(scene.objects.empty());
}

TEST_CASE("readScene reports all faults of a file at once, in its order", "[scene]") {
  CHECK(faultsOfFixture("many_faults.toml") ==
        "many_faults.toml:3:9: found 0, expected an integer from 1 to 268435456\n"
        "many_faults.toml:6:7: found 180, expected an angle above 0 and below 180 degrees\n"
        "many_faults.toml:8:11: found -1, expected an integer from 0 to 1024\n"
        "many_faults.toml:11:9: found no file 'missing.exr', expected a readable image file\n"
        "many_faults.toml:16:1: found no key 'radius', expected a number above 0 (at least "
        "1e-18)\n"
        "many_faults.toml:19:1: found key 'radus', expected one of shape, name, material, "
        "center or radius (did you mean 'radius'?)\n"
        "many_faults.toml:20:12: found material 'whit', expected the material white (did you "
        "mean 'white'?)");
}

TEST_CASE("readScene throws IoError for a file or folder that can't be read", "[scene]") {
  CHECK_THROWS_AS(readScene(fixture("no_such_file.toml")), IoError);
  CHECK_THROWS_AS(readScene(fixture("")), IoError);
}

TEST_CASE("readScene stops reading a file that never ends", "[scene]") {
  CHECK_THROWS_WITH(readScene("/dev/zero"),
                    "/dev/zero: found a larger file, expected at most 67108864 bytes");
}

TEST_CASE("isReadableFile is false for a folder", "[scene]") {
  CHECK(isReadableFile(fixture("full.toml")));
  CHECK_FALSE(isReadableFile(fixture("")));
  CHECK_FALSE(isReadableFile(fixture("no_such_file.toml")));
}

TEST_CASE("parseScene reports a name that can't stand in a file name", "[scene]") {
  const std::string expected = ", expected a name without '/' and control characters";
  CHECK(faultsOf("name = \"a/b\"") == "s.toml:1:8: found 'a/b'" + expected);
  CHECK(faultsOf("name = \"\"") == "s.toml:1:8: found ''" + expected);
  CHECK(faultsOf("name = \"a\\u0000b\"") == "s.toml:1:8: found 'a\\x00b'" + expected);
  CHECK(faultsOf("name = 3") == "s.toml:1:8: found 3" + expected);
}

TEST_CASE("parseScene reports unknown tables with the nearest known one", "[scene]") {
  CHECK(faultsOf("[camara]\nfov = 40") ==
        "s.toml:1:2: found table 'camara', expected one of name, film, render, camera, "
        "environment, materials, objects, lights or effects (did you mean 'camera'?)");
  CHECK(faultsOf("[[object]]") ==
        "s.toml:1:3: found table 'object', expected one of name, film, render, camera, "
        "environment, materials, objects, lights or effects (did you mean 'objects'?)");
}

TEST_CASE("parseScene reports a value where a table belongs", "[scene]") {
  CHECK(faultsOf("film = 3") == "s.toml:1:8: found 3, expected a table");
  CHECK(faultsOf("[objects]") ==
        "s.toml:1:1: found a table, expected tables, each headed [[objects]]");
  CHECK(faultsOf("lights = [1]") == "s.toml:1:11: found 1, expected a table");
  CHECK(faultsOf("[materials]\nwhite = true") ==
        "s.toml:2:9: found true for material 'white', expected a table, headed [materials.NAME]");
}

}  // namespace
}  // namespace twintrace
