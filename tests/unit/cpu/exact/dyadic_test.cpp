#include "cpu/exact/dyadic.h"

#include <random>

#include "tests/catch.h"

namespace twintrace::exact {
namespace {

/// The same number: three floats hold the 64 bits of a long double. For numbers between 2^-60 and
/// 2^60.
Dyadic exactly(long double value) {
  Dyadic sum(0.0f);
  for (int i = 0; i < 3; ++i) {
    // Through a variable in memory, since g++ 12 may drop a rounding to float between registers.
    const volatile float part = static_cast<float>(value);
    sum = sum + Dyadic(part);
    value -= part;
  }
  REQUIRE(value == 0.0L);
  return sum;
}

Dyadic magnitude(const Dyadic& x) {
  return x.sign() < 0 ? -x : x;
}

void checkBound(const Dyadic& number) {
  const FilterNumber filtered = number.filtered();
  INFO(number.integer() << " * 2^" << number.exponent() << " as "
                        << static_cast<double>(filtered.value()));
  CHECK((exactly(filtered.error()) - magnitude(number - exactly(filtered.value()))).sign() >= 0);
  CHECK(filtered.error() <= std::fabs(filtered.value()) * 0x1p-61L);
  CHECK(filtered.sign() == number.sign());
}

bool isUncertain(const FilterNumber& number) {
  try {
    number.sign();
    return false;
  } catch (const Uncertain&) {
    return true;
  }
}

}  // namespace

TEST_CASE("filtered is exact for integers of up to 63 bits times a power of two", "[exact]") {
  const float largest = std::numeric_limits<float>::max();
  const float smallest = std::numeric_limits<float>::min();
  for (const float value : {0.0f, 1.0f, -1.5f, largest, -largest, smallest, -smallest}) {
    const FilterNumber filtered = Dyadic(value).filtered();
    CHECK(filtered.value() == value);
    CHECK(filtered.error() == 0.0L);
  }
  const FilterNumber product = (Dyadic(largest) * Dyadic(-largest)).filtered();
  CHECK(product.value() == -static_cast<long double>(largest) * largest);
  CHECK(product.error() == 0.0L);
  const Dyadic odd(16777215.0f);
  const FilterNumber wide = (Dyadic(std::ldexp(16777215.0f, 39)) + odd).filtered();
  CHECK(wide.value() == 16777215.0L * (0x1p39L + 1.0L));
  CHECK(wide.error() == 0.0L);
  CHECK((Dyadic(std::ldexp(16777215.0f, 40)) + odd).filtered().error() > 0.0L);
}

TEST_CASE("filtered bounds the bits that it cuts off", "[exact]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-2.0f, 2.0f);
  for (int i = 0; i < 500; ++i) {
    Dyadic product(1.0f);
    for (int factor = 0; factor < 2 + i % 7; ++factor) product = product * Dyadic(uniform(random));
    if (std::fabs(product.filtered().value()) < 0x1p-30L) continue;
    checkBound(product);
    checkBound(product * product - Dyadic(uniform(random)));
  }
  // All ones, so that cutting loses most.
  Dyadic ones(0.0f);
  for (int bit = 0; bit < 64; ++bit) ones = ones + Dyadic(std::ldexp(1.0f, -bit));
  for (const Dyadic& number : {ones, -ones}) {
    CHECK(number.filtered().error() > 0.0L);
    checkBound(number);
  }
}

TEST_CASE("filtered leaves to exact numbers a sign that hangs on bits it cut off", "[exact]") {
  const Dyadic above = Dyadic(1.0f) + Dyadic(0x1p-100f);
  const Dyadic below = Dyadic(1.0f) - Dyadic(0x1p-100f);
  for (const Dyadic& number : {above, below}) {
    CHECK(isUncertain(number.filtered() - FilterNumber(1.0f)));
    CHECK(isUncertain(FilterNumber(1.0f) - number.filtered()));
    CHECK_FALSE(isUncertain(number.filtered() - FilterNumber(0.5f)));
  }
  CHECK((above - Dyadic(1.0f)).sign() == 1);
  CHECK((below - Dyadic(1.0f)).sign() == -1);
  // Nothing was cut off here, so that zero is certain.
  CHECK_FALSE(isUncertain(Dyadic(1.0f).filtered() - FilterNumber(1.0f)));
}

}  // namespace twintrace::exact
