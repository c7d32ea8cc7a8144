#include "common/film/canvas.h"

#include <cstddef>

#include "common/film/font.h"

namespace twintrace {

Canvas::Canvas(int width, int height, Colour background) {
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
  image_ = DisplayImage{width, height, std::vector<std::uint8_t>(size)};
  fillRectangle(0, 0, width, height, background);
}

void Canvas::setPixel(int x, int y, Colour colour) {
  if (x < 0 || y < 0 || x >= width() || y >= height()) return;
  const std::size_t pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(x);
  for (std::size_t i = 0; i < 3; ++i) image_.rgb[pixel * 3 + i] = colour[i];
}

void Canvas::fillRectangle(int x, int y, int width, int height, Colour colour) {
  for (int row = y; row < y + height; ++row) {
    for (int column = x; column < x + width; ++column) setPixel(column, row, colour);
  }
}

void Canvas::drawImage(int x, int y, const DisplayImage& image, int scale) {
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const std::size_t pixel =
          (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(column)) *
          3;
      const Colour colour = {image.rgb[pixel], image.rgb[pixel + 1], image.rgb[pixel + 2]};
      fillRectangle(x + column * scale, y + row * scale, scale, scale, colour);
    }
  }
}

void Canvas::drawText(int x, int y, std::string_view text, Colour colour, int scale) {
  for (const char character : text) {
    const Glyph& glyph = glyphOf(character);
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        if ((glyph[static_cast<std::size_t>(row)] >> (kGlyphWidth - 1 - column) & 1) == 0) continue;
        fillRectangle(x + column * scale, y + row * scale, scale, scale, colour);
      }
    }
    x += kCharacterAdvance * scale;
  }
}

}  // namespace twintrace
