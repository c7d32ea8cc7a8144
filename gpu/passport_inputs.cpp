#include "gpu/passport_inputs.h"

#include <bit>
#include <random>

namespace twintrace {
namespace {

constexpr int kRandomCount = 4096;  // of each kind

constexpr std::uint32_t kSpecial[] = {
    0x00000000u, 0x80000000u, 0x00000001u, 0x807fffffu, 0x00800000u, 0x80800000u, 0x00800001u,
    0x3f800000u, 0xbf800000u, 0x3f800001u, 0x3f7fffffu, 0x40000000u, 0x3f000000u, 0x40400000u,
    0xc0490fdbu, 0x4b000000u, 0x4b7fffffu, 0x4b800000u, 0x5f000000u, 0x7effffffu, 0x7f7fffffu,
    0xff7fffffu, 0x7f800000u, 0xff800000u, 0x7fc00000u};

class Triples {
 public:
  std::vector<std::uint32_t> words;

  void add(std::uint32_t a, std::uint32_t b) {
    words.push_back(a);
    words.push_back(b);
    words.push_back(ordinary());
  }
  void add(float a, float b) {
    add(std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b));
  }
  std::uint32_t any() { return random_(); }
  /// A number of size 2^-8 .. 2^8.
  std::uint32_t ordinary() {
    const std::uint32_t bits = random_();
    return (bits & 0x807fffffu) | ((119u + (random_() & 15u)) << 23);
  }
  /// An integer of 24 bits.
  std::uint32_t mantissa() { return 0x800000u | (random_() & 0x7fffffu); }

 private:
  std::mt19937 random_{1};
};

void addNearQuotient(Triples& triples) {
  const std::uint64_t halves = 2u * std::uint64_t{triples.mantissa()} + 1u;
  const std::uint32_t divisor = triples.mantissa();
  triples.add(static_cast<float>(halves * divisor), static_cast<float>(divisor));
}

void addNearRoot(Triples& triples) {
  const std::uint64_t halves = 2u * std::uint64_t{triples.mantissa()} + 1u;
  triples.add(static_cast<float>(halves * halves), 1.0f);
}

/// Factors whose product is just off a midpoint: b solves a b = 2^23 + 1 or - 1 modulo 2^24.
void addNearProduct(Triples& triples) {
  const std::uint32_t a = triples.mantissa() | 1u;
  std::uint32_t inverse = a;  // Newton's iteration, right in 3, 6, 12, 24 bits
  for (int i = 0; i < 4; ++i) inverse *= 2u - a * inverse;
  const std::uint32_t target = (triples.any() & 1u) != 0 ? 0x800001u : 0x7fffffu;
  const std::uint32_t b = (target * inverse) & 0xffffffu;
  triples.add(static_cast<float>(a), static_cast<float>(b | 0x800000u));
}

/// Terms half a unit in the last place of the other, and next to it.
void addNearSum(Triples& triples) {
  const auto a = static_cast<float>(triples.mantissa());
  const std::uint32_t half = 0x3f000000u + (triples.any() & 3u) - 1u;
  triples.add(std::bit_cast<std::uint32_t>(a), half | (triples.any() & 0x80000000u));
}

}  // namespace

std::vector<std::uint32_t> arithmeticInputs() {
  Triples triples;
  for (const std::uint32_t a : kSpecial) {
    for (const std::uint32_t b : kSpecial) triples.add(a, b);
  }
  for (int i = 0; i < kRandomCount; ++i) {
    triples.add(triples.any(), triples.any());
    triples.add(triples.ordinary(), triples.ordinary());
    addNearQuotient(triples);
    addNearRoot(triples);
    addNearProduct(triples);
    addNearSum(triples);
  }
  return triples.words;
}

}  // namespace twintrace
