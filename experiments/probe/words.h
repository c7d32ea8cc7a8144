#pragma once

#include <bit>
#include <cstdint>

namespace twintrace::probe {

/// Takes values out of packed 32-bit words.
struct WordReader {
  const std::uint32_t* at;

  void item(float& value) { value = std::bit_cast<float>(*at++); }
  void item(double& value) { value = static_cast<double>(std::bit_cast<float>(*at++)); }
  void item(std::int32_t& value) { value = static_cast<std::int32_t>(*at++); }
  void item(std::uint32_t& value) { value = *at++; }
  void item(bool& value) { value = (*at++ & 1u) != 0u; }
};

/// Packs values into 32-bit words.
struct WordWriter {
  std::uint32_t* at;

  void item(float value) { *at++ = std::bit_cast<std::uint32_t>(value); }
  void item(std::int32_t value) { *at++ = static_cast<std::uint32_t>(value); }
  void item(std::uint32_t value) { *at++ = value; }
  void item(bool value) { *at++ = value ? 1u : 0u; }
};

/// Writes values as doubles, which hold each of them exactly.
struct DoubleWriter {
  double* at;

  void item(double value) { *at++ = value; }
  void item(float value) { *at++ = static_cast<double>(value); }
  void item(std::int32_t value) { *at++ = value; }
  void item(std::uint32_t value) { *at++ = value; }
  void item(bool value) { *at++ = value ? 1.0 : 0.0; }
};

}  // namespace twintrace::probe
