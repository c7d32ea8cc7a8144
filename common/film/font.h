#pragma once

#include <array>
#include <cstdint>

namespace twintrace {

inline constexpr int kGlyphWidth = 5;
inline constexpr int kGlyphHeight = 7;

/// Rows of a glyph from the top; bit 4 is the leftmost pixel.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;

/// The glyph of an ASCII character. Small letters look like capitals; what the font lacks is a box.
const Glyph& glyphOf(char character);

}  // namespace twintrace
