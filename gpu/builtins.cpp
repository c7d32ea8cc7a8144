#include "gpu/builtins.h"

#include <bit>
#include <cmath>
#include <random>

namespace twintrace {
namespace {

constexpr ArgumentRange kUnused = {};
constexpr ArgumentRange kUnit = {-1.0, 1.0};
constexpr ArgumentRange kPart = {0.0, 1.0};
constexpr ArgumentRange kTurn = {-3.14159, 3.14159};
constexpr ArgumentRange kLong = {-1000.0, 1000.0};
constexpr ArgumentRange kPositive = {0.125, 8.0};
constexpr ArgumentRange kScales = {1e-6, 1e6, true};
constexpr ArgumentRange kAround = {-8.0, 8.0};

constexpr Builtin kBuiltins[] = {
    {"a / b", "a / b", kScales, kScales, kUnused},
    {"sqrt", "sqrt(a)", kScales, kUnused, kUnused},
    {"inversesqrt", "inversesqrt(a)", kScales, kUnused, kUnused},
    {"sin", "sin(a)", kTurn, kUnused, kUnused},
    {"sin, |x| < 1000", "sin(a)", kLong, kUnused, kUnused},
    {"cos", "cos(a)", kTurn, kUnused, kUnused},
    {"cos, |x| < 1000", "cos(a)", kLong, kUnused, kUnused},
    {"tan", "tan(a)", {-1.5, 1.5}, kUnused, kUnused},
    {"asin", "asin(a)", kUnit, kUnused, kUnused},
    {"acos", "acos(a)", kUnit, kUnused, kUnused},
    {"atan", "atan(a)", kLong, kUnused, kUnused},
    {"atan(y, x)", "atan(a, b)", kAround, kAround, kUnused},
    {"sinh", "sinh(a)", kAround, kUnused, kUnused},
    {"cosh", "cosh(a)", kAround, kUnused, kUnused},
    {"tanh", "tanh(a)", kAround, kUnused, kUnused},
    {"exp", "exp(a)", {-20.0, 20.0}, kUnused, kUnused},
    {"exp2", "exp2(a)", {-30.0, 30.0}, kUnused, kUnused},
    {"log", "log(a)", kScales, kUnused, kUnused},
    {"log2", "log2(a)", kScales, kUnused, kUnused},
    {"pow", "pow(a, b)", kPositive, kAround, kUnused},
    {"length", "length(vec3(a, b, c))", kAround, kAround, kAround},
    {"normalize, x", "normalize(vec3(a, b, c)).x", kAround, kAround, kAround},
    {"dot, positive", "dot(vec3(a, b, c), vec3(c, a, b))", kPositive, kPositive, kPositive},
    {"mix", "mix(a, b, c)", kPositive, kPositive, kPart},
    {"smoothstep", "smoothstep(0.25, 0.75, a)", kPart, kUnused, kUnused},
    {"reflect, y", "reflect(vec3(a, b, c), vec3(0.0, 0.6, 0.8)).y", kUnit, kUnit, kUnit},
    {"fract", "fract(a)", kLong, kUnused, kUnused},
    {"mod", "mod(a, b)", kLong, kPositive, kUnused},
};

float drawn(const ArgumentRange& range, std::mt19937& random) {
  const double u = static_cast<double>(random()) * 0x1p-32;
  if (!range.logarithmic) return static_cast<float>(range.low + (range.high - range.low) * u);
  return static_cast<float>(range.low * std::exp2(u * std::log2(range.high / range.low)));
}

float endOf(const ArgumentRange& range, bool high) {
  return static_cast<float>(high ? range.high : range.low);
}

}  // namespace

std::span<const Builtin> builtins() { return kBuiltins; }

std::vector<std::uint32_t> builtinInputs(const Builtin& builtin, std::size_t count,
                                         std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> words;
  for (std::size_t record = 0; record < count; ++record) {
    unsigned place = 1;
    for (const ArgumentRange& range : {builtin.a, builtin.b, builtin.c}) {
      const float value = record < 8 ? endOf(range, (record & place) != 0) : drawn(range, random);
      words.push_back(std::bit_cast<std::uint32_t>(value));
      place *= 2;
    }
  }
  return words;
}

}  // namespace twintrace
