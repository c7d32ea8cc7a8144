#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "common/film/image_io.h"

namespace twintrace {

using Colour = std::array<std::uint8_t, 3>;

/// A picture to draw display values and text on; what falls outside is cut off.
class Canvas {
 public:
  Canvas(int width, int height, Colour background);

  int width() const { return image_.width; }
  int height() const { return image_.height; }
  const DisplayImage& image() const { return image_; }

  void setPixel(int x, int y, Colour colour);
  void fillRectangle(int x, int y, int width, int height, Colour colour);

  /// Draws a picture with its upper left corner at (x, y), each pixel as scale x scale.
  void drawImage(int x, int y, const DisplayImage& image, int scale);

  /// Draws one line of text with its upper left corner at (x, y); font pixels are scale x scale.
  void drawText(int x, int y, std::string_view text, Colour colour, int scale);

 private:
  DisplayImage image_;
};

/// Advance of one character and of one line of text at scale 1.
inline constexpr int kCharacterAdvance = 6;
inline constexpr int kLineAdvance = 10;

}  // namespace twintrace
