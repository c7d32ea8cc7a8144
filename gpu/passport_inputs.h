#pragma once

#include <cstdint>
#include <vector>

namespace twintrace {

/// Bits of triples of floats that find arithmetic out: every pair of special values, any bit
/// patterns, ordinary numbers, and operands whose quotient, product or root lies next to the midpoint
/// of two floats. The same at every call.
std::vector<std::uint32_t> arithmeticInputs();

}  // namespace twintrace
