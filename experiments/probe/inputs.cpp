#include "experiments/probe/inputs.h"

// Inputs for shader functions. Most functions take any bit pattern; where a contract restricts a
// parameter (valid indices, random numbers in [0, 1], ...) or where arbitrary values would only ever
// take one branch, its name decides what is drawn: first "function.path", then "Struct.member", then
// the name alone, then whatever its type allows.

#include <fmt/format.h>

#include "common/base/error.h"
#include "common/base/flush_denormals.h"
#include "experiments/probe/input_domains.h"

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <string_view>

namespace twintrace::probe {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

/// What the names of the slot say to draw from, or nullptr.
template <class Domain>
const Domain* domainOf(const std::map<std::string, Domain, std::less<>>& domains,
                       const ShaderFunction& function, const Slot& slot) {
  const std::string_view path = slot.path;
  const std::size_t dot = path.rfind('.');
  const std::string name(dot == std::string_view::npos ? path : path.substr(dot + 1));
  for (const std::string& key :
       {std::string(function.name) + "." + slot.path, std::string(slot.owner) + "." + name, name}) {
    const auto found = domains.find(key);
    if (found != domains.end()) return &found->second;
  }
  return nullptr;
}

template <class Value>
Value draw(const Domains<Value>& domains, const ShaderFunction& function, const Slot& slot,
           Source& from, Value (*otherwise)(Source&)) {
  const auto* domain = domainOf(domains, function, slot);
  return domain != nullptr ? (*domain)(from) : otherwise(from);
}

int drawInteger(const ShaderFunction& function, const Slot& slot, Source& from) {
  const IntDomain* domain = domainOf(intDomains(), function, slot);
  return domain != nullptr ? domain->draw(from) : anyInteger(from);
}

bool isRayInverse(const Slot& slot) {
  return std::string_view(slot.owner) == "Ray" && std::string_view(slot.path).ends_with(".inverse");
}

// A ray's inverse belongs to its direction, the slot before it; see makeRay.
void invertDirection(std::uint32_t* words) {
  const FlushDenormals flush;
  for (int i = 0; i < 3; ++i) {
    const float d = std::bit_cast<float>(words[i - 3]);
    words[i] = std::bit_cast<std::uint32_t>(d == 0.0f ? kInf : 1.0f / d);
  }
}

void drawSlot(const ShaderFunction& function, const Slot& slot, Source& from, std::uint32_t* words) {
  switch (slot.kind) {
    case Kind::real:
      if (isRayInverse(slot)) {
        invertDirection(words);
      } else if (slot.size == 1) {
        const float value = draw(floatDomains(), function, slot, from, &anyFloat);
        words[0] = std::bit_cast<std::uint32_t>(value);
      } else {
        const Vector value = draw(vectorDomains(), function, slot, from, &anyVector);
        for (int i = 0; i < 3; ++i) words[i] = std::bit_cast<std::uint32_t>(value[i]);
      }
      return;
    case Kind::integer:
      words[0] = static_cast<std::uint32_t>(drawInteger(function, slot, from));
      return;
    case Kind::natural:
      for (int i = 0; i < slot.size; ++i) words[i] = anyNatural(from);
      return;
    case Kind::truth:
      words[0] = from.bits() & 1u;
      return;
  }
}

/// The finite float so many ulp further from zero; as it is where that leaves the finite ones.
std::uint32_t movedBy(std::uint32_t word, int ulps) {
  const std::int64_t size = (word & 0x7fffffffu) + std::int64_t{ulps};
  if ((word & 0x7f800000u) == 0x7f800000u || size < 0 || size >= 0x7f800000) return word;
  return (word & 0x80000000u) | static_cast<std::uint32_t>(size);
}

void addWithNeighbours(std::vector<std::uint32_t>& words, float value) {
  for (int ulps = -2; ulps <= 2; ++ulps) {
    for (const float side : {value, -value}) {
      words.push_back(movedBy(std::bit_cast<std::uint32_t>(side), ulps));
    }
  }
}

void checkInteger(const ShaderFunction& function, const Slot& slot, const World& world, int value) {
  const IntDomain* domain = domainOf(intDomains(), function, slot);
  if (domain == nullptr || !domain->bounds) return;
  if (domain->orNone && value == layout::kNoPrimitive) return;
  const IntRange range = domain->bounds(world);
  if (value >= range.least && value <= range.most) return;
  const std::string expected = range.least > range.most
                                   ? "a scene that has some"
                                   : fmt::format("{} to {}", range.least, range.most);
  throw UsageError(fmt::format("inputs: {}: found {}, expected {}", slot.path, value, expected));
}

}  // namespace

std::vector<std::uint32_t> drawInputs(const ShaderFunction& function, const World& world,
                                      std::size_t randomCount, std::uint64_t seed) {
  const auto stride = static_cast<std::size_t>(inputWords(function));
  const std::size_t count = kSpecialCount + randomCount;
  std::vector<std::uint32_t> inputs(count * stride);
  Source from(world, seed);
  for (std::size_t record = 0; record < count; ++record) {
    // All special at first, then one or two among ordinary values, then ordinary ones alone.
    from.specialChance = record < kSpecialCount / 2 ? 1.0 : record < kSpecialCount ? 0.15 : 0.0;
    std::uint32_t* words = &inputs[record * stride];
    for (const Slot& slot : function.inputs) {
      drawSlot(function, slot, from, words);
      words += slot.size;
    }
  }
  return inputs;
}

void checkInputs(const ShaderFunction& function, const World& world,
                 std::span<const std::uint32_t> record) {
  std::size_t at = 0;
  for (const Slot& slot : function.inputs) {
    if (slot.kind == Kind::integer) checkInteger(function, slot, world, static_cast<int>(record[at]));
    at += static_cast<std::size_t>(slot.size);
  }
}

std::vector<std::uint32_t> drawNear(const ShaderFunction& function,
                                    std::span<const std::uint32_t> record, std::size_t count,
                                    std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> ulps(-64, 64);
  std::vector<std::uint32_t> inputs;
  for (std::size_t i = 0; i < count; ++i) {
    inputs.insert(inputs.end(), record.begin(), record.end());
    std::uint32_t* words = &inputs[i * record.size()];
    for (const Slot& slot : function.inputs) {
      if (isRayInverse(slot)) {
        invertDirection(words);
      } else if (slot.kind == Kind::real) {
        for (int k = 0; k < slot.size; ++k) words[k] = movedBy(words[k], ulps(random));
      }
      words += slot.size;
    }
  }
  return inputs;
}

std::vector<std::uint32_t> boundaryInputs(const ShaderFunction& function) {
  constexpr int kMultiples = 1024;
  constexpr double kEighthTurn = 0.78539816339744830962;
  std::vector<std::uint32_t> words;
  if (function.inputs.size() != 1) return words;
  const Slot& slot = function.inputs.front();
  if (slot.kind != Kind::real || slot.size != 1) return words;
  if (domainOf(floatDomains(), function, slot) != nullptr) return words;
  for (int exponent = -126; exponent < 128; ++exponent) {
    addWithNeighbours(words, std::ldexp(1.0f, exponent));
    addWithNeighbours(words, std::ldexp(std::sqrt(0.5f), exponent));
  }
  for (int i = 1; i <= kMultiples; ++i) {
    addWithNeighbours(words, static_cast<float>(i * kEighthTurn));
    addWithNeighbours(words, static_cast<float>(i) * 0.5f);
  }
  return words;
}

}  // namespace twintrace::probe
