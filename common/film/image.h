#pragma once

#include <cstddef>
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

}  // namespace twintrace
