#include "common/scene/rotation.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "common/cast/case_random.h"
#include "tests/catch.h"

namespace twintrace {
namespace {

double largestDifference(const glm::dmat3& a, const glm::dmat3& b) {
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
  }
  return largest;
}

/// Angles are floats of up to 180 degrees: half an ulp of each is 1.4e-7 in radians.
constexpr double kRounding = 3.0 * 1.4e-7;

TEST_CASE("rotationMatrix turns counterclockwise, about x, then y, then z", "[scene]") {
  const glm::dmat3 aboutX = rotationMatrix({90.0f, 0.0f, 0.0f});
  CHECK(largestDifference(aboutX, glm::dmat3(1, 0, 0, 0, 0, 1, 0, -1, 0)) < 1e-15);
  const glm::dmat3 aboutY = rotationMatrix({0.0f, 90.0f, 0.0f});
  CHECK(largestDifference(aboutY, glm::dmat3(0, 0, -1, 0, 1, 0, 1, 0, 0)) < 1e-15);
  const glm::dmat3 aboutZ = rotationMatrix({0.0f, 0.0f, 90.0f});
  CHECK(largestDifference(aboutZ, glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1)) < 1e-15);
  CHECK(largestDifference(rotationMatrix({90.0f, 90.0f, 90.0f}), aboutZ * aboutY * aboutX) < 1e-15);
}

TEST_CASE("rotationAngles gives angles of the same rotation", "[scene]") {
  CaseRandom random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::dmat3 rotation = random.rotation();
    CHECK(largestDifference(rotationMatrix(rotationAngles(rotation)), rotation) < kRounding);
  }
}

TEST_CASE("rotationAngles holds where the turn about y is a right angle, and next to it",
          "[scene]") {
  CaseRandom random(2);
  for (const double y : {90.0, -90.0, 89.9999, -89.9999}) {
    for (int i = 0; i < 20; ++i) {
      const glm::vec3 first(random.uniform(-180.0, 180.0), y, random.uniform(-180.0, 180.0));
      // As a product of two others, whose entries are rounded.
      const glm::dmat3 other = random.rotation();
      const glm::dmat3 rotation = other * (glm::transpose(other) * rotationMatrix(first));
      INFO(first.x << " " << first.y << " " << first.z);
      CHECK(largestDifference(rotationMatrix(rotationAngles(rotation)), rotation) < kRounding);
    }
  }
}

TEST_CASE("rotationAngles holds for all quarter turns", "[scene]") {
  for (int x = -180; x <= 180; x += 90) {
    for (int y = -180; y <= 180; y += 90) {
      for (int z = -180; z <= 180; z += 90) {
        const glm::dmat3 rotation = rotationMatrix(glm::vec3(x, y, z));
        INFO(x << " " << y << " " << z);
        CHECK(largestDifference(rotationMatrix(rotationAngles(rotation)), rotation) < kRounding);
      }
    }
  }
}

}  // namespace
}  // namespace twintrace
