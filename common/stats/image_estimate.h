#pragma once

#include <string>
#include <vector>

#include "common/film/image.h"
#include "common/film/image_io.h"

namespace twintrace {

/// A picture with the uncertainty of each value.
struct ImageEstimate {
  Image mean;
  /// Standard error of each value; infinite where it is not known (fewer than two frames).
  Image standardError;
  /// Frames behind each pixel's standard error; empty if not known, then taken as many.
  std::vector<float> count;
};

/// @throws UsageError unless both pictures have the same size and at least one pixel.
void requireSameSize(const Image& a, const Image& b);

/// The estimate that a file of our own holds: standard error = sqrt(Variance / count).
/// @param name how messages call the picture.
/// @throws UsageError if the content has no Variance and count channels.
ImageEstimate estimateFrom(const ExrContent& content, const std::string& name);

/// An estimate with a picture of standard errors from elsewhere.
/// @throws UsageError if the sizes differ or a standard error is negative or NaN.
ImageEstimate estimateFrom(const Image& mean, const Image& standardError);

}  // namespace twintrace
