#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace twintrace {

/// A linear RGB picture in memory: three floats per pixel, row-major, row 0 on top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;

  Image() = default;
  Image(int imageWidth, int imageHeight)
      : width(imageWidth), height(imageHeight), rgb(pixelCount() * 3, 0.0f) {}

  std::size_t pixelCount() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  bool empty() const { return rgb.empty(); }
  bool sameSize(const Image& other) const { return width == other.width && height == other.height; }
};

/// One named value per pixel beside a picture, for example a map of a comparison.
struct NamedChannel {
  std::string name;
  std::vector<float> values;
};

/// A pixel's place; y counts from the top.
struct PixelPosition {
  int x = 0;
  int y = 0;
  bool operator==(const PixelPosition&) const = default;
};

/// Index of a pixel in row order.
inline std::size_t pixelIndex(const PixelPosition& pixel, int width) {
  return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(pixel.x);
}

/// The three values of the pixel with this index.
inline std::array<float, 3> valueAt(std::span<const float> rgb, std::size_t pixel) {
  return {rgb[3 * pixel], rgb[3 * pixel + 1], rgb[3 * pixel + 2]};
}

}  // namespace twintrace
