#pragma once

#include <string>

#include "experiments/comparison.h"

namespace twintrace {

/// Two pictures from anywhere; empty names of standard errors mean none.
struct PictureFiles {
  std::string a;
  std::string b;
  std::string standardErrorA;
  std::string standardErrorB;
};

/// Compares two pictures. They are paired, and judged by bits, if both are ours and drew the same
/// samples of the same scene, or if nothing is known of their samples and all bits are equal; else
/// they are tested with the errors given, or with those in their Variance and count channels, and
/// inconclusive where none are known.
/// @throws IoError for files that can't be read, UsageError for unequal sizes.
Comparison compareFiles(const PictureFiles& files, const ComparisonSettings& settings);

}  // namespace twintrace
