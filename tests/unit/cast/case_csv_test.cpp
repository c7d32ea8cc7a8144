#include "common/cast/case_csv.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

#include "common/base/error.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

constexpr const char* kAll =
    "scene,one # every kind\n"
    "sphere,ball,0,0.1,-0,-2\n"
    "box,crate,1,2,3,-1,0x1p-3,4\n"
    "obb,turned,0,0,0,1,1,0,-1,1,0,0,0,1,1,2,3\n"
    "plane,floor,0,1,0,0,-1,0\n"
    "tri,sail,0,0,0,1,0,0,0,1,0\n"
    "ray,a,0,0,-5,0,0,1,0,inf\n"
    "ray,b,0,0,-5,1e-45,0,1,0,nan\n"
    "scene,two\n"
    "sphere,ball,1,2,3,4\n"
    "ray,a,1,2,3,4,5,6,-7,8\n";

CasesFile parse(const std::string& text) {
  return parseCases(text, "c.csv");
}

std::string faultsOf(const std::string& text) {
  try {
    parse(text);
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

std::string written(const CaseSet& cases) {
  std::ostringstream out;
  writeCases(out, cases);
  return out.str();
}

TEST_CASE("parseCases reads every kind of primitive, normalised", "[cast]") {
  const CaseSet cases = parse(kAll).cases;
  REQUIRE(cases.primitives.size() == 6);
  CHECK(cases.primitives[0].kind == CaseKind::sphere);
  CHECK(cases.primitives[0].vector(0) == glm::vec3(0.0f, 0.1f, 0.0f));
  CHECK(cases.primitives[0].values[3] == 2.0f);
  CHECK(cases.primitives[1].kind == CaseKind::box);
  CHECK(cases.primitives[1].vector(0) == glm::vec3(-1.0f, 0.125f, 3.0f));
  CHECK(cases.primitives[1].vector(3) == glm::vec3(1.0f, 2.0f, 4.0f));
  CHECK(cases.primitives[2].kind == CaseKind::orientedBox);
  CHECK(cases.primitives[2].vector(6) == glm::vec3(-1.0f, 1.0f, 0.0f));
  CHECK(cases.primitives[2].vector(12) == glm::vec3(1.0f, 2.0f, 3.0f));
  CHECK(cases.primitives[3].kind == CaseKind::plane);
  CHECK(cases.primitives[3].vector(3) == glm::vec3(0.0f, -1.0f, 0.0f));
  CHECK(cases.primitives[4].kind == CaseKind::triangle);
  CHECK(cases.primitives[4].vector(6) == glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST_CASE("parseCases lets a ray see the primitives of its scene", "[cast]") {
  const CasesFile file = parse(kAll);
  const CaseSet& cases = file.cases;
  REQUIRE(cases.rays.size() == 3);
  CHECK(cases.primitivesOf(cases.rays[1]).size() == 5);
  CHECK(cases.primitivesOf(cases.rays[2]).size() == 1);
  CHECK(cases.primitivesOf(cases.rays[2])[0].values[3] == 4.0f);
  CHECK(cases.rays[2].ray.tmin == -7.0f);
  CHECK(file.nanRays == 1);
}

TEST_CASE("parseCases takes names from the file", "[cast]") {
  const CaseSet cases = parse(kAll).cases;
  CHECK(sceneName(cases, 1) == "two");
  CHECK(rayName(cases, 1) == "b");
  CHECK(primitiveName(cases, cases.rays[0], 4) == "sail");
  CHECK(primitiveName(cases, cases.rays[2], 0) == "ball");
}

TEST_CASE("parseCases has a scene without a name before the first scene line", "[cast]") {
  const CaseSet cases = parse("sphere,s,0,0,0,1\nray,r,0,0,0,0,0,1,0,1\nscene,x\n").cases;
  REQUIRE(cases.scenes.size() == 2);
  CHECK(sceneName(cases, 0).empty());
  CHECK(cases.primitivesOf(cases.rays[0]).size() == 1);
  CHECK(parse("# nothing\n").cases.scenes.empty());
}

TEST_CASE("parseCases knows its records", "[cast]") {
  CHECK(
      faultsOf("spere,a,0,0,0,1\n") ==
      "c.csv:1:1: found 'spere', expected scene, sphere, box, obb, plane, tri or ray (did you mean "
      "'sphere'?)");
}

TEST_CASE("parseCases counts the values of each record", "[cast]") {
  CHECK(faultsOf("scene\n") == "c.csv:1:1: found 1 values, expected scene,NAME");
  CHECK(faultsOf("sphere,a,0,0,0\n") == "c.csv:1:1: found 5 values, expected sphere,ID,cx,cy,cz,r");
  CHECK(faultsOf("box,a,0\n") ==
        "c.csv:1:1: found 3 values, expected box,ID,xmin,ymin,zmin,xmax,ymax,zmax");
  CHECK(faultsOf("obb,a\n") ==
        "c.csv:1:1: found 2 values, expected obb,ID, centre, three axes and three half sizes: 17 "
        "values");
  CHECK(faultsOf("plane,a,0,1,0,0,0,0,0\n") ==
        "c.csv:1:1: found 9 values, expected plane,ID,nx,ny,nz,px,py,pz");
  CHECK(faultsOf("tri,a\n") ==
        "c.csv:1:1: found 2 values, expected tri,ID, three vertices: 11 values");
  CHECK(faultsOf(" ray,a,0\n") ==
        "c.csv:1:2: found 3 values, expected ray,ID,ox,oy,oz,dx,dy,dz,tmin,tmax");
}

TEST_CASE("parseCases wants finite numbers in primitives", "[cast]") {
  CHECK(faultsOf("sphere,a,nan,0,1e39,one\n") ==
        "c.csv:1:10: found 'nan', expected a finite number in float32\n"
        "c.csv:1:16: found '1e39', expected a finite number in float32\n"
        "c.csv:1:21: found 'one', expected a number");
}

TEST_CASE("parseCases wants every name once in its scene", "[cast]") {
  CHECK(faultsOf("scene,s\nsphere,a,0,0,0,1\nplane,a,0,1,0,0,0,0\nscene,s\n") ==
        "c.csv:3:7: found 'a' as in line 2, expected a name of its own\n"
        "c.csv:4:7: found 's' as in line 1, expected a name of its own");
  CHECK(faultsOf("ray,r,0,0,0,0,0,1,0,1\nray,r,0,0,0,0,0,1,0,1\n") ==
        "c.csv:2:5: found 'r' as in line 1, expected a name of its own");
  CHECK(faultsOf("sphere,,0,0,0,1\n") == "c.csv:1:8: found nothing, expected a name");
}

TEST_CASE("parseCases wants a scene's primitives before its rays", "[cast]") {
  CHECK(faultsOf("ray,r,0,0,0,0,0,1,0,1\nsphere,a,0,0,0,1\nscene,t\nsphere,a,0,0,0,1\n") ==
        "c.csv:2:1: found a primitive after a ray, expected a scene's primitives before its rays");
}

TEST_CASE("readCases says that a file can't be read", "[cast]") {
  CHECK_THROWS_AS(readCases("no/such/cases.csv"), IoError);
}

TEST_CASE("writeCases writes what reads back with the same bits", "[cast]") {
  CaseSet cases = parse(kAll).cases;
  cases.rays[0].ray.origin = {std::numeric_limits<float>::max(), 0x1.fffffep-126f, -0.0f};
  const CaseSet again = parse(written(cases)).cases;
  CHECK(written(again) == written(cases));
  REQUIRE(again.primitives.size() == cases.primitives.size());
  for (std::size_t i = 0; i < cases.primitives.size(); ++i) {
    CHECK(again.primitives[i].kind == cases.primitives[i].kind);
    CHECK(std::bit_cast<std::array<std::uint32_t, 15>>(again.primitives[i].values) ==
          std::bit_cast<std::array<std::uint32_t, 15>>(cases.primitives[i].values));
  }
  CHECK(again.rays[0].ray.origin == cases.rays[0].ray.origin);
  CHECK(std::signbit(again.rays[0].ray.origin.z));
  CHECK(again.rays[1].ray.direction.x == 1e-45f);
  CHECK(again.sceneNames == cases.sceneNames);
  CHECK(again.primitiveNames == cases.primitiveNames);
  CHECK(again.rayNames == cases.rayNames);
}

TEST_CASE("writeCases names by index what has no name, and spares what files can't hold",
          "[cast]") {
  CaseSet cases;
  cases.primitives.resize(2);
  cases.scenes = {{0, 1}, {1, 1}};
  cases.rays = {{{}, 1}, {{}, 0}};
  const std::string zeros = ",0x0p+0,0x0p+0,0x0p+0,0x0p+0\n";
  const std::string ray = ",0x0p+0,0x0p+0,0x0p+0,0x0p+0,0x0p+0,0x1p+0,0x0p+0,0x1.fffffep+127\n";
  CHECK(written(cases) ==
        "scene,0\nsphere,0" + zeros + "ray,1" + ray + "scene,1\nsphere,0" + zeros + "ray,0" + ray);
  cases.sceneNames = {"a,b", "c #1"};
  CHECK(written(cases).find("scene,a_b\n") == 0);
  CHECK(written(cases).find("scene,c__1\n") != std::string::npos);
}

TEST_CASE("selectRays keeps the names, scenes and bounces of the rays", "[cast]") {
  CaseSet cases;
  cases.primitives.resize(3);
  cases.primitives[2].values[3] = 7.0f;
  cases.scenes = {{0, 1}, {1, 2}};
  cases.rays = {{{}, 0}, {{}, 1}, {{}, 1}};
  cases.bounces = {{0.1f, 0.2f}, {0.3f, 0.4f}, {0.5f, 0.6f}};
  const std::array<std::size_t, 2> chosen = {1, 2};
  const CaseSet selected = selectRays(cases, chosen);
  REQUIRE(selected.rays.size() == 2);
  CHECK(selected.scenes.size() == 1);
  CHECK(selected.primitivesOf(selected.rays[1])[1].values[3] == 7.0f);
  CHECK(rayName(selected, 0) == "1");
  CHECK(sceneName(selected, 0) == "1");
  CHECK(primitiveName(selected, selected.rays[0], 1) == "1");
  CHECK(selected.bounces == std::vector<Bounce>{{0.3f, 0.4f}, {0.5f, 0.6f}});
}

TEST_CASE("writeCaseHit names what was hit", "[cast]") {
  const CaseSet cases = parse(kAll).cases;
  std::ostringstream out;
  writeCaseHitsHeader(out);
  writeCaseHit(out, cases, 0, "exact", {4, 5.0, {0, 0, 1}, Clarity::tie});
  writeCaseHit(out, cases, 1, "gpu", {});
  writeCaseHit(out, cases, 2, "cpu", {-1, 0.0, {}, Clarity::clean});
  CHECK(out.str() ==
        "scene,ray,engine,prim,t,nx,ny,nz,class\n"
        "one,a,exact,sail,0x1.4p+2,0x0p+0,0x0p+0,0x1p+0,tie\n"
        "one,b,gpu,-1,,,,,\n"
        "two,a,cpu,-1,,,,,clean\n");
}

}  // namespace
}  // namespace twintrace
