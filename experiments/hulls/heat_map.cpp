#include "experiments/hulls/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "common/film/canvas.h"
#include "common/film/sheet_tiles.h"

namespace twintrace {
namespace {

// Black through purple and orange to white: brightness grows all the way, for eyes of every kind.
constexpr std::array<Colour, 6> kHeat = {
    {{0, 0, 4}, {66, 10, 104}, {147, 38, 103}, {221, 81, 58}, {252, 165, 10}, {252, 255, 220}}};
constexpr Colour kPaper = {250, 250, 248};
constexpr Colour kInk = {24, 24, 28};
constexpr int kTextScale = 2;
constexpr int kLine = kLineAdvance * kTextScale;
constexpr int kMargin = 8;
constexpr int kLeastWidth = 360;

int testsOf(const HullCounts& counts) {
  return counts.hullTests + counts.primitiveTests;
}

int textWidth(const std::string& text) {
  return static_cast<int>(text.size()) * kCharacterAdvance * kTextScale;
}

void drawBar(Canvas& canvas, int y, int width, int most) {
  for (int x = 0; x < width; ++x) {
    const double position = (x + 0.5) / width;
    canvas.fillRectangle(kMargin + x, y, 1, kLine, colourAt(kHeat, position));
  }
  const std::string last = std::to_string(most);
  const std::string middle = std::to_string(most / 2);
  const int below = y + kLine + 4;
  canvas.drawText(kMargin, below, "0", kInk, kTextScale);
  canvas.drawText(kMargin + (width - textWidth(middle)) / 2, below, middle, kInk, kTextScale);
  canvas.drawText(kMargin + width - textWidth(last), below, last, kInk, kTextScale);
}

}  // namespace

DisplayImage drawHeatMap(int width, int height, std::span<const HullCounts> counts,
                         const std::string& title) {
  assert(counts.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  int most = 1;
  double sum = 0.0;
  for (const HullCounts& each : counts) {
    most = std::max(most, testsOf(each));
    sum += testsOf(each);
  }
  const int scale = std::max(1, (kLeastWidth + width - 1) / width);
  const std::string told = fmt::format("tests a ray: mean {:.1f}, most {}",
                                       sum / static_cast<double>(counts.size()), most);
  const int inner = std::max({width * scale, textWidth(title), textWidth(told)});
  Canvas canvas(inner + 2 * kMargin, height * scale + 4 * kLine + 5 * kMargin, kPaper);
  canvas.drawText(kMargin, kMargin, title, kInk, kTextScale);
  canvas.drawText(kMargin, kMargin + kLine, told, kInk, kTextScale);
  const int top = 2 * kMargin + 2 * kLine;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      const double position = static_cast<double>(testsOf(counts[at])) / most;
      canvas.fillRectangle(kMargin + x * scale, top + y * scale, scale, scale, colourAt(kHeat, position));
    }
  }
  drawBar(canvas, top + height * scale + kMargin, width * scale, most);
  return canvas.image();
}

}  // namespace twintrace
