#include "common/cast/case_random.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace twintrace {
namespace {

constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15u;

std::uint64_t scramble(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

glm::dvec3 unit(const glm::dvec3& v) {
  return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

}  // namespace

std::uint64_t CaseRandom::bits() {
  state_ += kGoldenStep;
  return scramble(state_);
}

double CaseRandom::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double CaseRandom::logarithmic(double low, double high) {
  const int first = std::ilogb(low);
  const int last = std::ilogb(high);
  for (;;) {
    const double value = std::ldexp(1.0 + uniform(), integer(first, last));
    if (value >= low && value <= high) return value;
  }
}

int CaseRandom::integer(int low, int high) {
  const auto count = static_cast<std::uint64_t>(high - low) + 1;
  return low + static_cast<int>((bits() >> 8) % count);
}

glm::dvec3 CaseRandom::inCube(double halfSize) {
  const double x = uniform(-halfSize, halfSize);
  const double y = uniform(-halfSize, halfSize);
  const double z = uniform(-halfSize, halfSize);
  return {x, y, z};
}

glm::dvec3 CaseRandom::inBall() {
  for (;;) {
    const glm::dvec3 v = inCube(1.0);
    if (glm::dot(v, v) <= 1.0) return v;
  }
}

glm::dvec3 CaseRandom::direction() {
  for (;;) {
    const glm::dvec3 v = inBall();
    if (glm::dot(v, v) > 1e-4) return unit(v);
  }
}

glm::dvec3 CaseRandom::perpendicular(const glm::dvec3& direction) {
  for (;;) {
    const glm::dvec3 v = glm::cross(direction, this->direction());
    if (glm::dot(v, v) > 1e-2 * glm::dot(direction, direction)) return unit(v);
  }
}

glm::dmat3 CaseRandom::rotation() {
  const glm::dvec3 x = direction();
  const glm::dvec3 y = perpendicular(x);
  return {x, y, glm::cross(x, y)};
}

std::uint64_t mixSeed(std::uint64_t seed, std::uint64_t index) {
  return scramble(scramble(seed + kGoldenStep) ^ (index + 1) * kGoldenStep);
}

}  // namespace twintrace
