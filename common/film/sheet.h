#pragma once

#include <string>
#include <vector>

#include "common/film/image.h"
#include "common/film/image_io.h"

namespace twintrace {

/// What a comparison shows on one page; all pictures and maps have the same size.
struct SheetContent {
  std::vector<std::string> header;  ///< lines of ASCII: the verdict and its numbers
  std::string nameA = "a";
  std::string nameB = "b";
  Image a;
  Image b;
  std::vector<float> ulp;  ///< per pixel, as ulpMap() gives it; empty: no such tile
  Image z;                 ///< as zMap() gives it; empty: no such tile
};

/// Draws a, b, their difference times a stated gain (a power of ten that makes the largest
/// difference visible), ULP on a logarithmic scale and z from -5 to 5, each with a caption, under
/// the header. Small pictures are enlarged by a whole factor.
DisplayImage drawSheet(const SheetContent& content);

/// Draws the sheet into a PNG. @throws IoError if it can't be written.
void writeSheet(const std::string& path, const SheetContent& content);

}  // namespace twintrace
