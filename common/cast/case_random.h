#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace twintrace {

/// Random numbers of one case. Only integer arithmetic, + - * / and square roots, so that the same
/// cases are drawn by every standard library. Generator: SplitMix64 (Steele, Lea, Flood 2014).
class CaseRandom {
 public:
  explicit CaseRandom(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits();

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// A power of two times a number that is uniform in [1, 2), over [low, high]: every binade is as
  /// likely as another. Both bounds positive.
  double logarithmic(double low, double high);

  /// Uniform integer in [low, high]. The bias of the remainder is below 2^-40 here.
  int integer(int low, int high);
  bool chance(double probability) { return uniform() < probability; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

  glm::dvec3 inCube(double halfSize);
  glm::dvec3 inBall();
  glm::dvec3 direction();                                 ///< unit
  glm::dvec3 perpendicular(const glm::dvec3& direction);  ///< unit
  glm::dmat3 rotation();                                  ///< columns are the axes

 private:
  std::uint64_t state_;
};

/// A generator of its own for each member of a sequence.
std::uint64_t mixSeed(std::uint64_t seed, std::uint64_t index);

}  // namespace twintrace
