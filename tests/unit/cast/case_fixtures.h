#pragma once

#include <cmath>
#include <initializer_list>
#include <random>

#include "common/cast/case_set.h"

namespace twintrace::test {

inline CasePrimitive primitiveOf(CaseKind kind, std::initializer_list<float> values) {
  CasePrimitive primitive{kind, {}};
  std::size_t i = 0;
  for (const float value : values) primitive.values[i++] = value;
  return normalised(primitive);
}

inline CasePrimitive unitSphere() { return primitiveOf(CaseKind::sphere, {0, 0, 0, 1}); }
inline CasePrimitive unitBox() { return primitiveOf(CaseKind::box, {-1, -1, -1, 1, 1, 1}); }
/// Turned by 45 degrees about z, half size 1.
inline CasePrimitive turnedBox() {
  const float s = std::sqrt(0.5f);
  return primitiveOf(CaseKind::orientedBox, {0, 0, 0, s, s, 0, -s, s, 0, 0, 0, 1, 1, 1, 1});
}
/// z = 0, its normal along +z and two long.
inline CasePrimitive groundPlane() { return primitiveOf(CaseKind::plane, {0, 0, 2, 0, 0, 0}); }
/// In z = 0 around the origin, its normal along +z.
inline CasePrimitive flatTriangle() {
  return primitiveOf(CaseKind::triangle, {-1, -1, 0, 1, -1, 0, 0, 1, 0});
}

/// One scene that all rays see.
inline CaseSet casesOf(std::vector<CasePrimitive> primitives, const std::vector<CastRay>& rays) {
  CaseSet cases;
  cases.primitives = std::move(primitives);
  cases.scenes.push_back({0, static_cast<std::uint32_t>(cases.primitives.size())});
  for (const CastRay& ray : rays) cases.rays.push_back({ray, 0});
  return cases;
}

/// One ray in a scene of its own.
inline CastHit castOne(CaseEngine& engine, const std::vector<CasePrimitive>& primitives,
                       const CastRay& ray) {
  return engine.cast(casesOf(primitives, {ray})).at(0);
}

/// Random scenes of one to three primitives of all kinds, each with a ray aimed near its middle, at
/// scales and offsets that differ from scene to scene.
class RandomCases {
 public:
  explicit RandomCases(std::uint64_t seed) : random_(seed) {}

  CaseSet draw(int count, bool bounces) {
    CaseSet cases;
    for (int i = 0; i < count; ++i) {
      scale_ = std::exp2(static_cast<float>(integer(-40, 40)));
      const auto first = static_cast<std::uint32_t>(cases.primitives.size());
      const int size = integer(1, 3);
      for (int k = 0; k < size; ++k) cases.primitives.push_back(normalised(primitive()));
      cases.scenes.push_back({first, static_cast<std::uint32_t>(size)});
      cases.rays.push_back({ray(), static_cast<std::uint32_t>(i)});
      if (bounces) cases.bounces.emplace_back(std::abs(real()), std::abs(real()));
    }
    return cases;
  }

 private:
  float real() { return std::uniform_real_distribution<float>(-1.0f, 1.0f)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  CasePrimitive primitive() {
    CasePrimitive made{static_cast<CaseKind>(integer(0, 4)), {}};
    for (int i = 0; i < valueCount(made.kind); ++i) {
      made.values[static_cast<std::size_t>(i)] = real() * scale_;
    }
    if (made.kind == CaseKind::orientedBox) setAxes(made);
    return made;
  }

  // The axes of a random rotation, from a quaternion.
  void setAxes(CasePrimitive& box) {
    float q[4] = {real(), real(), real(), real()};
    const float size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (float& part : q) part /= size;
    const auto [w, x, y, z] = std::tuple(q[0], q[1], q[2], q[3]);
    const float axes[9] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
                           2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                           2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
    for (std::size_t i = 0; i < 9; ++i) box.values[3 + i] = axes[i];
  }

  CastRay ray() {
    const glm::vec3 origin = glm::vec3(real(), real(), real()) * (3.0f * scale_);
    const glm::vec3 target = glm::vec3(real(), real(), real()) * (0.7f * scale_);
    const float speed = std::exp2(static_cast<float>(integer(-30, 30)));
    glm::vec3 direction = (target - origin) / scale_ * speed;
    if (integer(0, 7) == 0) direction[integer(0, 2)] = 0.0f;
    return {origin, direction};
  }

  std::mt19937_64 random_;
  float scale_ = 1.0f;
};

}  // namespace twintrace::test
