#include "common/film/sheet_tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace twintrace {
namespace {

constexpr Colour kBlack = {0, 0, 0};
constexpr Colour kMagenta = {255, 0, 255};
constexpr double kUlpScaleBits = 24;  // a difference of all mantissa bits ends the scale
constexpr double kLargestZ = 5.0;

// Even the smallest distance has to stand out from black, which means equal.
constexpr std::array<Colour, 5> kUlpColours = {
    {{75, 60, 190}, {160, 45, 150}, {225, 90, 50}, {250, 180, 40}, {255, 255, 190}}};
constexpr std::array<Colour, 5> kZColours = {
    {{30, 60, 150}, {130, 170, 225}, {255, 255, 255}, {235, 150, 120}, {150, 20, 40}}};

Colour ulpColour(double ulp) {
  return ulp == 0.0 ? kBlack : colourAt(kUlpColours, std::log2(ulp) / kUlpScaleBits);
}

Colour zColour(double z) {
  if (std::isnan(z)) return kMagenta;
  return colourAt(kZColours, 0.5 + 0.5 * z / kLargestZ);
}

template <class ColourOf>
DisplayImage drawMap(int width, int height, const ColourOf& colourOf) {
  DisplayImage picture{width, height, {}};
  const std::size_t pixelCount = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t pixel = 0; pixel < pixelCount; ++pixel) {
    const Colour colour = colourOf(pixel);
    picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
  }
  return picture;
}

/// The smallest power of ten, at least 1, that lifts the largest finite difference to 0.5.
double gainFor(const Image& a, const Image& b) {
  float largest = 0.0f;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const float difference = std::abs(a.rgb[i] - b.rgb[i]);
    if (std::isfinite(difference)) largest = std::max(largest, difference);
  }
  if (largest == 0.0f) return 1.0;
  return std::pow(10.0, std::max(0.0, std::ceil(std::log10(0.5 / double(largest)))));
}

SheetTile differenceTile(const SheetContent& content) {
  const double gain = gainFor(content.a, content.b);
  Image difference(content.a.width, content.a.height);
  for (std::size_t i = 0; i < difference.rgb.size(); ++i) {
    const float a = content.a.rgb[i];
    const float b = content.b.rgb[i];
    const bool bothNan = std::isnan(a) && std::isnan(b);
    difference.rgb[i] =
        a == b || bothNan ? 0.0f : static_cast<float>(gain * std::abs(double(a) - b));
  }
  char caption[64];
  std::snprintf(caption, sizeof(caption), "difference x %.10g", gain);
  return {caption, toDisplay(difference), {}, {}};
}

SheetTile ulpTile(const SheetContent& content) {
  const auto colourOf = [&](std::size_t pixel) { return ulpColour(content.ulp[pixel]); };
  std::vector<LegendLabel> labels = {{0.0, "1"}};
  for (const int bits : {4, 8, 12, 16, 20, 24}) {
    labels.push_back({bits / kUlpScaleBits, "2^" + std::to_string(bits)});
  }
  return {"ULP distance (black: equal)", drawMap(content.a.width, content.a.height, colourOf),
          kUlpColours, labels};
}

/// z of the channel that is farthest from 0, or a NaN of any channel.
float strongestZ(const Image& z, std::size_t pixel) {
  float strongest = 0.0f;
  for (std::size_t i = pixel * 3; i < pixel * 3 + 3; ++i) {
    if (std::isnan(z.rgb[i])) return z.rgb[i];
    if (std::abs(z.rgb[i]) > std::abs(strongest)) strongest = z.rgb[i];
  }
  return strongest;
}

SheetTile zTile(const SheetContent& content) {
  const auto colourOf = [&](std::size_t pixel) { return zColour(strongestZ(content.z, pixel)); };
  return {"z: (a - b) / standard error",
          drawMap(content.a.width, content.a.height, colourOf),
          kZColours,
          {{0.0, "-5"}, {0.25, "-2.5"}, {0.5, "0"}, {0.75, "2.5"}, {1.0, "5"}}};
}

}  // namespace

Colour colourAt(std::span<const Colour> colours, double position) {
  const double scaled = std::clamp(position, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const std::size_t index = std::min(static_cast<std::size_t>(scaled), colours.size() - 2);
  const double weight = scaled - static_cast<double>(index);
  Colour colour;
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = (1.0 - weight) * colours[index][i] + weight * colours[index + 1][i];
    colour[i] = static_cast<std::uint8_t>(std::lround(value));
  }
  return colour;
}

std::vector<SheetTile> sheetTiles(const SheetContent& content) {
  std::vector<SheetTile> tiles;
  tiles.push_back({"a: " + content.nameA, toDisplay(content.a), {}, {}});
  tiles.push_back({"b: " + content.nameB, toDisplay(content.b), {}, {}});
  tiles.push_back(differenceTile(content));
  if (!content.ulp.empty()) tiles.push_back(ulpTile(content));
  if (!content.z.empty()) tiles.push_back(zTile(content));
  return tiles;
}

}  // namespace twintrace
