#include "common/film/sheet.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/film/canvas.h"
#include "common/film/sheet_tiles.h"

namespace twintrace {
namespace {

constexpr Colour kBackground = {250, 250, 248};
constexpr Colour kText = {24, 24, 28};
constexpr int kSmallestTile = 360;  // pixels; smaller pictures are enlarged
constexpr int kCaptionLines = 2;

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
  int tileWidth;  ///< of the picture, enlarged
  int tileHeight;
  int columns;

  Layout(const Image& picture, std::size_t tileCount) {
    scale = std::max(1, (kSmallestTile + picture.width - 1) / picture.width);
    tileWidth = picture.width * scale;
    tileHeight = picture.height * scale;
    textScale = std::max(2, tileWidth / kSmallestTile);
    margin = 8 * textScale;
    columns = tileCount > 4 ? 3 : 2;
  }

  int lineHeight() const { return kLineAdvance * textScale; }
  int width() const { return margin + columns * (tileWidth + margin); }
  int rowHeight(bool hasLegend) const {
    return (kCaptionLines + (hasLegend ? 2 : 0)) * lineHeight() + tileHeight + margin;
  }
  std::size_t charactersIn(int pixels) const {
    return static_cast<std::size_t>(std::max(1, pixels / (kCharacterAdvance * textScale)));
  }
};

/// Upper edges of the rows of tiles, and the lower edge of the last one.
std::vector<int> rowEdges(const std::vector<SheetTile>& tiles, const Layout& layout, int top) {
  std::vector<int> edges = {top};
  const std::size_t columns = static_cast<std::size_t>(layout.columns);
  for (std::size_t first = 0; first < tiles.size(); first += columns) {
    const auto begin = tiles.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end =
        tiles.begin() + static_cast<std::ptrdiff_t>(std::min(first + columns, tiles.size()));
    const bool hasLegend =
        std::any_of(begin, end, [](const SheetTile& tile) { return !tile.legend.empty(); });
    edges.push_back(edges.back() + layout.rowHeight(hasLegend));
  }
  return edges;
}

void drawLegend(Canvas& canvas, int x, int y, const SheetTile& tile, const Layout& layout) {
  const int barHeight = layout.lineHeight() - 2 * layout.textScale;
  for (int column = 0; column < layout.tileWidth; ++column) {
    const double position = (column + 0.5) / layout.tileWidth;
    canvas.fillRectangle(x + column, y, 1, barHeight, colourAt(tile.legend, position));
  }
  for (const LegendLabel& label : tile.labels) {
    const int textWidth =
        static_cast<int>(label.text.size()) * kCharacterAdvance * layout.textScale;
    const int place =
        static_cast<int>(std::lround(label.position * (layout.tileWidth - textWidth)));
    canvas.drawText(x + place, y + layout.lineHeight(), label.text, kText, layout.textScale);
  }
}

void drawTile(Canvas& canvas, int x, int y, const SheetTile& tile, const Layout& layout) {
  std::vector<std::string> caption = wrapText(tile.caption, layout.charactersIn(layout.tileWidth));
  if (caption.size() > static_cast<std::size_t>(kCaptionLines)) {
    caption.resize(static_cast<std::size_t>(kCaptionLines));
  }
  int line = y + (kCaptionLines - static_cast<int>(caption.size())) * layout.lineHeight();
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
  const std::vector<SheetTile> tiles = sheetTiles(content);
  const Layout layout(content.a, tiles.size());
  std::vector<std::string> header;
  for (const std::string& line : content.header) {
    const auto lines = wrapText(line, layout.charactersIn(layout.width() - 2 * layout.margin));
    header.insert(header.end(), lines.begin(), lines.end());
  }
  const int top = 2 * layout.margin + static_cast<int>(header.size()) * layout.lineHeight();
  const std::vector<int> edges = rowEdges(tiles, layout, top);

  Canvas canvas(layout.width(), edges.back(), kBackground);
  for (std::size_t i = 0; i < header.size(); ++i) {
    const int y = layout.margin + static_cast<int>(i) * layout.lineHeight();
    canvas.drawText(layout.margin, y, header[i], kText, layout.textScale);
  }
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const std::size_t columns = static_cast<std::size_t>(layout.columns);
    const int x =
        layout.margin + static_cast<int>(i % columns) * (layout.tileWidth + layout.margin);
    drawTile(canvas, x, edges[i / columns], tiles[i], layout);
  }
  return canvas.image();
}

void writeSheet(const std::string& path, const SheetContent& content) {
  writePng(path, drawSheet(content));
}

}  // namespace twintrace
