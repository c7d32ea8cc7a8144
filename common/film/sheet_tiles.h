#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/film/canvas.h"
#include "common/film/sheet.h"

namespace twintrace {

/// A mark below the colour bar of a tile.
struct LegendLabel {
  double position = 0.0;  ///< along the bar, 0 to 1
  std::string text;
};

/// One picture of a sheet with what is written above and below it.
struct SheetTile {
  std::string caption;
  DisplayImage picture;
  std::span<const Colour> legend;  ///< colours of the bar, evenly spaced; empty: no bar
  std::vector<LegendLabel> labels;
};

/// The colour at a place of an evenly spaced scale; positions outside 0 to 1 get the end colours.
Colour colourAt(std::span<const Colour> colours, double position);

/// The tiles that the content calls for: a, b, difference, ULP, z.
std::vector<SheetTile> sheetTiles(const SheetContent& content);

}  // namespace twintrace
