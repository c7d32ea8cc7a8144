#pragma once

#include <span>
#include <string>

#include "common/film/image_io.h"
#include "common/hulls/hull_counts.h"

namespace twintrace {

/// A picture of what each pixel's ray costs: hull and primitive tests together, black for none and up to
/// white for the largest, with a bar that tells the numbers and a line of text above.
/// @param counts one for each pixel, row by row
DisplayImage drawHeatMap(int width, int height, std::span<const HullCounts> counts,
                         const std::string& title);

}  // namespace twintrace
