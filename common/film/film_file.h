#pragma once

#include <string>

#include "common/film/film.h"

namespace twintrace {

/// Writes a film's exact sums, for merging later. Equal films make equal bytes. Layout, little
/// endian: "TWINFILM", version, size of the header, header (JSON: size, passes, sample ranges,
/// metadata, places of bad frames), per pixel and channel the 128-bit sum and sum of squares, per
/// pixel the count of bad frames, XXH3 of all that.
/// @throws IoError if the file can't be written; then no file is left behind.
void writeFilm(const std::string& path, const Film& film);

/// Reads a film. @throws IoError if the file can't be read, FileError if it is not a whole and
/// undamaged film of a known version.
Film readFilm(const std::string& path);

}  // namespace twintrace
