#pragma once

#include <random>

#include "common/stats/batch_means.h"

namespace twintrace::test {

/// A picture whose values come from calling `draw(random)`.
template <class Draw>
Image randomImage(int width, int height, std::mt19937_64& random, const Draw& draw) {
  Image image(width, height);
  for (float& value : image.rgb) value = static_cast<float>(draw(random));
  return image;
}

/// Batches of such pictures.
template <class Draw>
BatchMeans randomBatches(int width, int height, int batchCount, std::mt19937_64& random,
                         const Draw& draw) {
  BatchMeans batches(width, height);
  for (int i = 0; i < batchCount; ++i) batches.add(randomImage(width, height, random, draw));
  return batches;
}

/// The same value everywhere in every batch.
inline BatchMeans constantBatches(int width, int height, int batchCount, float value) {
  std::mt19937_64 random;
  return randomBatches(width, height, batchCount, random, [=](auto&) { return value; });
}

}  // namespace twintrace::test
