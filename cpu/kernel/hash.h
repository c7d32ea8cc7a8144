#pragma once

// Twin of shaders/hash.glsl: random numbers as functions of integer counters.

#include "cpu/kernel/math.h"
#include "cpu/kernel/scene_view.h"

TWINTRACE_KERNEL_BEGIN

/// State that a sample's random numbers derive from.
template <class R>
struct SampleKey {
  UintOf<R> first;
  UintOf<R> second;
  UintOf<R> frame;  ///< the same in all pixels of a sample
};

/// PCG-RXS-M-XS-32 as a hash. O'Neill 2014; as a hash: Jarzynski and Olano 2020.
template <class Uint>
Uint pcgHash(Uint value) {
  const Uint state = value * Uint(747796405u) + Uint(2891336453u);
  const Uint word = ((state >> ((state >> 28u) + Uint(4u))) ^ state) * Uint(277803737u);
  return (word >> 22u) ^ word;
}

/// The top 24 bits as a number in [0, 1); exact.
template <class R>
R unitFloat(UintOf<R> bits) {
  return toNumber<R>(toSigned(bits >> 8u)) * R(5.9604644775390625e-8f);
}

/// The report's noise, eq. 9-10: in [0, 1].
template <class R>
R sineHash(R x, R y) {
  const R raised = sine(x * R(14.4527f) + y * R(76.8761f)) * R(39282.6275f);
  return raised - floorOf(raised);
}

/// Key of one sample of one pixel.
template <class R>
SampleKey<R> makeSampleKey(const SceneView& scene, IntOf<R> x, IntOf<R> y, int width,
                           UintOf<R> sampleIndex, std::uint32_t seed) {
  using Uint = UintOf<R>;
  const Uint frame = pcgHash(sampleIndex + pcgHash(Uint(seed)));
  const Uint hashed = pcgHash(toUnsigned(y * IntOf<R>(width) + x) + frame);
  const Uint column = toUnsigned(x);
  const Uint row = toUnsigned(y);
  const Uint latticeX = column * Uint(2654435761u) + row * Uint(2246822519u) +
                        sampleIndex * Uint(3266489917u) + Uint(seed) * Uint(668265263u);
  const Uint latticeY = column * Uint(374761393u) + row * Uint(3266489917u) +
                        sampleIndex * Uint(2654435761u) + Uint(seed) * Uint(2246822519u);
  return {scene.noiseSine ? latticeX : hashed, latticeY, frame};
}

/// The random number in [0, 1] (sine) or [0, 1) (pcg) of a decision within a sample.
template <class R>
R noise(const SceneView& scene, const SampleKey<R>& key, IntOf<R> bounce, int dimension) {
  using Uint = UintOf<R>;
  using N = NoiseOf<R>;
  // Unsigned, since ended paths in other lanes go on counting bounces.
  const Uint counter = (toUnsigned(bounce) * Uint(kCounterStride) + toUnsigned(IntOf<R>(dimension))) *
                       Uint(2654435769u);
  if (scene.noiseSine) {
    return widened<R>(sineHash(unitFloat<N>(key.first + counter),
                               unitFloat<N>(key.second + counter * Uint(3u))));
  }
  const Uint atBounce = pcgHash(key.first + toUnsigned(bounce) * Uint(2654435769u));
  const Uint along = toUnsigned(IntOf<R>(dimension)) * Uint(2246822519u);
  return widened<R>(unitFloat<N>(pcgHash(atBounce + along)));
}

TWINTRACE_KERNEL_END
