#include "common/film/sheet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <span>

#include "common/film/canvas.h"

namespace twintrace {
namespace {

constexpr Colour kBackground = {250, 250, 248};
constexpr Colour kText = {24, 24, 28};
constexpr Colour kMagenta = {255, 0, 255};
constexpr int kSmallestTile = 360;    // pixels; smaller pictures are enlarged
constexpr double kUlpScaleBits = 24;  // a difference of all mantissa bits ends the scale
constexpr double kLargestZ = 5.0;

/// Colours between which a scale from 0 to 1 is interpolated.
constexpr std::array<Colour, 6> kUlpColours = {
    {{0, 0, 0}, {60, 15, 110}, {150, 40, 110}, {225, 90, 50}, {250, 180, 40}, {255, 255, 190}}};
constexpr std::array<Colour, 5> kZColours = {
    {{30, 60, 150}, {130, 170, 225}, {255, 255, 255}, {235, 150, 120}, {150, 20, 40}}};

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

Colour ulpColour(double ulp) {
  return colourAt(kUlpColours, std::log2(1.0 + ulp) / kUlpScaleBits);
}

Colour zColour(double z) {
  if (std::isnan(z)) return kMagenta;
  return colourAt(kZColours, 0.5 + 0.5 * z / kLargestZ);
}

struct Label {
  double position;  ///< along the legend, 0 to 1
  std::string text;
};

struct Tile {
  std::string caption;
  DisplayImage picture;
  std::span<const Colour> legend;  ///< empty: none
  std::vector<Label> labels;
};

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

/// The smallest power of ten, at least 1, that lifts the largest finite difference to 0.1.
double gainFor(const Image& a, const Image& b) {
  float largest = 0.0f;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const float difference = std::abs(a.rgb[i] - b.rgb[i]);
    if (std::isfinite(difference)) largest = std::max(largest, difference);
  }
  if (largest == 0.0f) return 1.0;
  return std::pow(10.0, std::max(0.0, std::ceil(std::log10(0.1 / double(largest)))));
}

Tile differenceTile(const SheetContent& content) {
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
  std::snprintf(caption, sizeof(caption), "|a - b| x %.10g", gain);
  return {caption, toDisplay(difference), {}, {}};
}

Tile ulpTile(const SheetContent& content) {
  const auto colourOf = [&](std::size_t pixel) { return ulpColour(content.ulp[pixel]); };
  std::vector<Label> labels = {{0.0, "0"}};
  for (const int bits : {4, 8, 12, 16, 20, 24}) {
    labels.push_back({bits / kUlpScaleBits, "2^" + std::to_string(bits)});
  }
  return {"largest distance, ULP", drawMap(content.a.width, content.a.height, colourOf),
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

Tile zTile(const SheetContent& content) {
  const auto colourOf = [&](std::size_t pixel) { return zColour(strongestZ(content.z, pixel)); };
  return {"z: (a - b) / standard error",
          drawMap(content.a.width, content.a.height, colourOf),
          kZColours,
          {{0.0, "-5"}, {0.25, "-2.5"}, {0.5, "0"}, {0.75, "2.5"}, {1.0, "5"}}};
}

std::vector<Tile> tilesOf(const SheetContent& content) {
  std::vector<Tile> tiles;
  tiles.push_back({"a: " + content.nameA, toDisplay(content.a), {}, {}});
  tiles.push_back({"b: " + content.nameB, toDisplay(content.b), {}, {}});
  tiles.push_back(differenceTile(content));
  if (!content.ulp.empty()) tiles.push_back(ulpTile(content));
  if (!content.z.empty()) tiles.push_back(zTile(content));
  return tiles;
}

/// Breaks text at spaces into lines of at most `columns` characters; longer words are cut.
std::vector<std::string> wrapText(const std::string& text, std::size_t columns) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > columns) {
    const std::size_t space = rest.rfind(' ', columns);
    const std::size_t cut = space == std::string::npos || space == 0 ? columns : space;
    lines.push_back(rest.substr(0, cut));
    rest.erase(0, rest[cut] == ' ' ? cut + 1 : cut);
  }
  lines.push_back(rest);
  return lines;
}

/// Sizes of a sheet's parts in pixels.
struct Layout {
  int scale;  ///< enlargement of pictures
  int textScale;
  int margin;
  int tileWidth;
  int tileHeight;  ///< of the picture alone
  int captionLines;
  int columns;

  Layout(const SheetContent& content, int tileCount) {
    scale = std::max(1, (kSmallestTile + content.a.width - 1) / content.a.width);
    tileWidth = content.a.width * scale;
    tileHeight = content.a.height * scale;
    textScale = std::max(2, tileWidth / kSmallestTile);
    margin = 8 * textScale;
    captionLines = 2;
    columns = tileCount > 4 ? 3 : 2;
  }

  int lineHeight() const { return kLineAdvance * textScale; }
  int legendHeight() const { return 2 * lineHeight(); }
  int cellHeight() const {
    return captionLines * lineHeight() + tileHeight + legendHeight() + margin;
  }
  int width() const { return margin + columns * (tileWidth + margin); }
  std::size_t charactersIn(int pixels) const {
    return static_cast<std::size_t>(std::max(1, pixels / (kCharacterAdvance * textScale)));
  }
};

void drawLegend(Canvas& canvas, int x, int y, const Tile& tile, const Layout& layout) {
  const int barHeight = layout.lineHeight() - 2 * layout.textScale;
  for (int column = 0; column < layout.tileWidth; ++column) {
    const double position = (column + 0.5) / layout.tileWidth;
    canvas.fillRectangle(x + column, y, 1, barHeight, colourAt(tile.legend, position));
  }
  for (const Label& label : tile.labels) {
    const int textWidth =
        static_cast<int>(label.text.size()) * kCharacterAdvance * layout.textScale;
    const int place =
        static_cast<int>(std::lround(label.position * (layout.tileWidth - textWidth)));
    canvas.drawText(x + place, y + layout.lineHeight(), label.text, kText, layout.textScale);
  }
}

void drawTile(Canvas& canvas, int x, int y, const Tile& tile, const Layout& layout) {
  std::vector<std::string> caption = wrapText(tile.caption, layout.charactersIn(layout.tileWidth));
  if (caption.size() > static_cast<std::size_t>(layout.captionLines)) {
    caption.resize(static_cast<std::size_t>(layout.captionLines));
  }
  int line = y + (layout.captionLines - static_cast<int>(caption.size())) * layout.lineHeight();
  for (const std::string& text : caption) {
    canvas.drawText(x, line, text, kText, layout.textScale);
    line += layout.lineHeight();
  }
  canvas.drawImage(x, line, tile.picture, layout.scale);
  if (!tile.legend.empty())
    drawLegend(canvas, x, line + layout.tileHeight + 2 * layout.textScale, tile, layout);
}

}  // namespace

DisplayImage drawSheet(const SheetContent& content) {
  assert(content.a.sameSize(content.b) && !content.a.empty());
  const std::vector<Tile> tiles = tilesOf(content);
  const Layout layout(content, static_cast<int>(tiles.size()));
  std::vector<std::string> header;
  for (const std::string& line : content.header) {
    const auto wrapped = wrapText(line, layout.charactersIn(layout.width() - 2 * layout.margin));
    header.insert(header.end(), wrapped.begin(), wrapped.end());
  }
  const int headerHeight = layout.margin + static_cast<int>(header.size()) * layout.lineHeight();
  const int rows = (static_cast<int>(tiles.size()) + layout.columns - 1) / layout.columns;
  Canvas canvas(layout.width(), headerHeight + rows * layout.cellHeight() + layout.margin,
                kBackground);
  for (std::size_t i = 0; i < header.size(); ++i) {
    canvas.drawText(layout.margin, layout.margin + static_cast<int>(i) * layout.lineHeight(),
                    header[i], kText, layout.textScale);
  }
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const int column = static_cast<int>(i) % layout.columns;
    const int row = static_cast<int>(i) / layout.columns;
    drawTile(canvas, layout.margin + column * (layout.tileWidth + layout.margin),
             headerHeight + row * layout.cellHeight(), tiles[i], layout);
  }
  return canvas.image();
}

void writeSheet(const std::string& path, const SheetContent& content) {
  writePng(path, drawSheet(content));
}

}  // namespace twintrace
