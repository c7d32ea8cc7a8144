#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/film/film.h"
#include "common/film/image.h"

namespace twintrace {

/// Everything in a rendered EXR file.
struct ExrContent {
  Image image;               ///< channels R, G, B
  Image variance;            ///< Variance.R, ...: sample variance of frame means; may be empty
  std::vector<float> count;  ///< frames per pixel; may be empty
  std::vector<NamedChannel> extra;  ///< further channels, such as comparison maps
  FilmMetadata metadata;            ///< written as "twintrace:KEY"
};

/// Mean, variance and count of a film, with its metadata and the entries `passes` and `samples`.
ExrContent exrContent(const Film& film);

/// Writes a float EXR, ZIP-compressed. Equal content makes equal bytes.
/// @throws IoError with OpenImageIO's message; then no file is left behind.
void writeExr(const std::string& path, const ExrContent& content);

/// Reads an image of any float format. R, G, B are found by name, else they are the first three
/// channels, or the first one thrice; Variance.* and count are read where the file has them, other
/// channels go to `extra`.
/// @throws IoError if the file can't be read, FileError if it has more than kMaxPixels pixels.
ExrContent readExr(const std::string& path);

/// Reads a linear picture, such as an environment (EXR, HDR): only R, G, B, found as in readExr.
/// @throws IoError if the file can't be read, FileError if it is too large or holds integers,
/// which are display values and not linear ones.
Image readLinearImage(const std::string& path);

/// Rows of 8-bit RGB, as shown on a display.
struct DisplayImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// A linear value in [0, 1] as an 8-bit sRGB code; clipped outside, NaN gives 0.
std::uint8_t srgbCode(float linear);

/// A picture at exposure 0, clipped, no filmic curve; pixels with a NaN are magenta.
DisplayImage toDisplay(const Image& image);

/// Writes a PNG. Equal content makes equal bytes. @throws IoError with OpenImageIO's message.
void writePng(const std::string& path, const DisplayImage& image);
void writePng(const std::string& path, const Image& image);

/// Version of OpenImageIO that this program was built with.
std::string imageLibraryVersion();

}  // namespace twintrace
