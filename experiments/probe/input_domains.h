#pragma once

// What parameters of shader functions are drawn from, by their names.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>

#include "experiments/probe/worlds.h"

namespace twintrace::probe {

/// Where a value is drawn from: a generator of random numbers, and whether special values are due.
class Source {
 public:
  Source(const World& world, std::uint64_t seed) : world(world), random_(seed) {}

  const World& world;
  double specialChance = 0.0;

  bool special() { return real() < specialChance; }
  double real() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  float uniform(double low, double high) { return static_cast<float>(low + (high - low) * real()); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  std::uint32_t bits() { return static_cast<std::uint32_t>(random_()); }
  template <std::size_t n>
  float oneOf(const float (&values)[n]) {
    return values[bits() % n];
  }

 private:
  std::mt19937_64 random_;
};

using Vector = std::array<float, 3>;

template <class Value>
using Domains = std::map<std::string, std::function<Value(Source&)>, std::less<>>;

/// Both ends included; empty if most < least.
struct IntRange {
  int least = 0;
  int most = 0;
};

/// How an int is drawn. One that says where to read in a scene also has bounds, outside of which no
/// function may be called with it; without bounds a function may be called with any value.
struct IntDomain {
  std::function<int(Source&)> draw;
  std::function<IntRange(const World&)> bounds;
  bool orNone = false;  ///< whether kNoPrimitive will do, too
};

/// Domains by "function.path", "Struct.member" or the name alone.
const Domains<float>& floatDomains();
const Domains<Vector>& vectorDomains();
const std::map<std::string, IntDomain, std::less<>>& intDomains();

/// Whatever a type allows.
float anyFloat(Source& from);
Vector anyVector(Source& from);
int anyInteger(Source& from);
std::uint32_t anyNatural(Source& from);

}  // namespace twintrace::probe
