#pragma once

#include <string>
#include <vector>

#include "experiments/comparison.h"

namespace twintrace {

/// Finds out before the work whether a file can be written afterwards; leaves nothing behind.
/// @throws IoError if its directory is missing or can't be written, or if the name is a
/// directory's.
void checkWritable(const std::string& path);

/// Makes a directory with its parents and checks that it can be written. @throws IoError if not.
void prepareDirectory(const std::string& path);

/// @throws UsageError unless the name ends in one of the extensions, such as ".exr".
void checkExtension(const std::string& path, const std::vector<std::string>& extensions);

/// Writes a text file as a whole or not at all. @throws IoError if it can't be written.
void writeText(const std::string& path, const std::string& text);

/// Writes a.exr, b.exr, a.png, b.png, diff.exr (difference a - b with the maps ulp and z) and
/// sheet.png, on which `header` stands above the pictures.
void writeComparisonPictures(const std::string& directory, const Comparison& comparison,
                             const std::vector<std::string>& header, const std::string& nameA,
                             const std::string& nameB);

}  // namespace twintrace
