#include "common/cast/rays_csv.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "common/base/error.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

constexpr const char* kHeader = "ox,oy,oz,dx,dy,dz,tmin,tmax\n";

RaysFile rowsOf(const std::string& rows) {
  return parseRays(kHeader + rows, "r.csv");
}

std::string faultsOf(const std::string& text) {
  try {
    parseRays(text, "r.csv");
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST_CASE("parseRays reads decimal and hex numbers to the nearest float", "[cast]") {
  const auto file = rowsOf("0.1,-0,0x1.8p+1,1e-3,0X1p-126,+2,0,inf\n");
  REQUIRE(file.rays.size() == 1);
  const CastRay& ray = file.rays[0];
  CHECK(ray.origin.x == 0.1f);
  CHECK(std::signbit(ray.origin.y));
  CHECK(ray.origin.z == 3.0f);
  CHECK(ray.direction == glm::vec3(1e-3f, 0x1p-126f, 2.0f));
  CHECK(ray.tmax == std::numeric_limits<float>::infinity());
}

TEST_CASE("parseRays rounds once, from the text to float", "[cast]") {
  // Just above the middle of 1 and its neighbour; by way of double it would be the middle itself.
  CHECK(rowsOf("1.00000005960464477539062500001,0,0,0,0,1,0,1").rays[0].origin.x == 0x1.000002p0f);
  CHECK(rowsOf("1.000000059604644775390625,0,0,0,0,1,0,1").rays[0].origin.x == 1.0f);
  CHECK(rowsOf("0x1.0000010000000000000001p0,0,0,0,0,1,0,1").rays[0].origin.x == 0x1.000002p0f);
}

TEST_CASE("parseRays takes comments, CRLF, spaces, empty lines and a byte order mark", "[cast]") {
  const auto file = parseRays(
      "\xef\xbb\xbf# rays\r\n ox, oy,oz,dx,dy,dz,tmin,tmax \r\n\r\n"
      "  1 , 2,3,\t0,0,1,0,9 # a ray\r\n4,5,6,0,0,1,0,9",
      "r.csv");
  REQUIRE(file.rays.size() == 2);
  CHECK(file.rays[0].origin == glm::vec3(1, 2, 3));
  CHECK(file.rays[1].origin == glm::vec3(4, 5, 6));
}

TEST_CASE("parseRays keeps and counts rays with a NaN", "[cast]") {
  const auto file = rowsOf("nan,0,0,0,0,1,0,1\n0,0,0,0,0,1,0,-NaN\n0,0,0,0,0,1,0,1\n");
  CHECK(file.rays.size() == 3);
  CHECK(file.nanRays == 2);
  CHECK(std::isnan(file.rays[0].origin.x));
}

TEST_CASE("parseRays reads a file without rays", "[cast]") {
  CHECK(parseRays(kHeader, "r.csv").rays.empty());
}

TEST_CASE("parseRays asks for its header", "[cast]") {
  CHECK(faultsOf("") ==
        "r.csv:1:1: found an empty file, expected the header ox,oy,oz,dx,dy,dz,tmin,tmax");
  CHECK(faultsOf("0,0,0,0,0,1,0,1\n") ==
        "r.csv:1:1: found '0', expected the header ox,oy,oz,dx,dy,dz,tmin,tmax");
  CHECK(faultsOf("ox,oy,oz,dx,dy,dz,tmax,tmin\n") ==
        "r.csv:1:19: found 'tmax', expected the header ox,oy,oz,dx,dy,dz,tmin,tmax");
  CHECK(faultsOf("# rays\n ox,oy,oz,dx,dy,dz\n") ==
        "r.csv:2:2: found 6 columns, expected the header ox,oy,oz,dx,dy,dz,tmin,tmax");
}

TEST_CASE("parseRays reports every malformed row and value at once", "[cast]") {
  CHECK(faultsOf(std::string(kHeader) + "0,0,0,0,0,1,0\n"
                                        "0,0,0,0,0,1,0,1\n"
                                        "0,zero,0,0, 1.5x ,1,0,\n") ==
        "r.csv:2:1: found 7 values, expected 8 values, ox,oy,oz,dx,dy,dz,tmin,tmax\n"
        "r.csv:4:3: found 'zero', expected a number\n"
        "r.csv:4:13: found '1.5x', expected a number\n"
        "r.csv:4:23: found '', expected a number");
}

TEST_CASE("parseRays refuses what only strtof takes for a number", "[cast]") {
  CHECK(faultsOf(std::string(kHeader) + "nan(1),0,0,0,0,1,0,1\n") ==
        "r.csv:2:1: found 'nan(1)', expected a number");
}

TEST_CASE("readRays says that a file can't be read", "[cast]") {
  CHECK_THROWS_AS(readRays("no/such/rays.csv"), IoError);
  CHECK_THROWS_AS(readRays(TWINTRACE_TEST_DATA), IoError);
}

TEST_CASE("writeRayHit writes hex floats, and little of a miss", "[cast]") {
  std::ostringstream out;
  writeRayHitsHeader(out);
  writeRayHit(out, 0, "cpu", {"ball, \"red\"", 2, 1.5, {0.0, -1.0, 0.0}});
  writeRayHit(out, 1, "cpu", {});
  CHECK(out.str() ==
        "ray,engine,hit,object,primitive,t,nx,ny,nz\n"
        "0,cpu,1,\"ball, \"\"red\"\"\",2,0x1.8p+0,0x0p+0,-0x1p+0,0x0p+0\n"
        "1,cpu,0,,-1,,,,\n");
}

}  // namespace
}  // namespace twintrace
