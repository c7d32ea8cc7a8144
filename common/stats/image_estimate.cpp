#include "common/stats/image_estimate.h"

#include <cmath>
#include <limits>

#include "common/base/error.h"

namespace twintrace {
namespace {

std::string sizeText(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

}  // namespace

void requireSameSize(const Image& a, const Image& b) {
  if (a.sameSize(b) && a.pixelCount() > 0) return;
  throw UsageError("found pictures of " + sizeText(a) + " and " + sizeText(b) +
                   " pixels, expected equal sizes");
}

ImageEstimate estimateFrom(const ExrContent& content, const std::string& name) {
  if (content.variance.empty() || content.count.empty()) {
    throw UsageError(name + " has no Variance.R, Variance.G, Variance.B and count channels, " +
                     "expected them or a picture of standard errors");
  }
  ImageEstimate estimate{content.image, content.variance, content.count};
  for (std::size_t i = 0; i < estimate.standardError.rgb.size(); ++i) {
    const float count = estimate.count[i / 3];
    float& value = estimate.standardError.rgb[i];
    value = count >= 2.0f ? std::sqrt(value / count) : std::numeric_limits<float>::infinity();
  }
  return estimate;
}

ImageEstimate estimateFrom(const Image& mean, const Image& standardError) {
  requireSameSize(mean, standardError);
  for (const float value : standardError.rgb) {
    if (!(value >= 0.0f)) {
      throw UsageError("found a standard error of " + std::to_string(value) +
                       ", expected 0 or more");
    }
  }
  return {mean, standardError, {}};
}

}  // namespace twintrace
