#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace twintrace {

/// The values from which one argument of a builtin is drawn.
struct ArgumentRange {
  double low = 0;
  double high = 0;
  bool logarithmic = false;  ///< equally many values per octave; low > 0 then
};

/// A function of GLSL whose precision is the driver's affair.
struct Builtin {
  const char* name;        ///< also says the range where it has more than one row
  const char* expression;  ///< of a, b and c, type float
  ArgumentRange a, b, c;
};

/// The builtins that a passport measures.
std::span<const Builtin> builtins();

/// Bits of `count` records of arguments, of which the first have the ends of the ranges.
std::vector<std::uint32_t> builtinInputs(const Builtin& builtin, std::size_t count,
                                         std::uint32_t seed);

}  // namespace twintrace
