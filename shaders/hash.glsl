// Random numbers as functions of integer counters: the same (pixel, sample, bounce, dimension) gives
// the same value in every tracer, in any order of evaluation.
#pragma once

#include "math.glsl"

// State that a sample's random numbers derive from.
struct SampleKey {
  uint first;
  uint second;
  uint frame;  // the same in all pixels of a sample; the report's estimator seeds from it
};

// PCG-RXS-M-XS-32 as a hash. O'Neill 2014; as a hash: Jarzynski and Olano 2020, "Hash Functions for
// GPU Rendering".
uint pcgHash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// The top 24 bits as a float in [0, 1); exact.
float unitFloat(uint bits) {
  precise float result = float(int(bits >> 8u)) * 5.9604644775390625e-8f;
  return result;
}

// The report's noise, eq. 9-10: in [0, 1].
float sineHash(float x, float y) {
  precise float angle = x * 14.4527f + y * 76.8761f;
  precise float raised = sine(angle) * 39282.6275f;
  precise float result = raised - floor(raised);
  return result;
}

// Key of one sample of one pixel. For the sine hash the counters enter a Weyl lattice that the hash
// alone must break up, so that its own quality shows; the factors are odd constants of xxHash32.
SampleKey makeSampleKey(int x, int y, int width, uint sampleIndex, uint seed) {
  uint frame = pcgHash(sampleIndex + pcgHash(seed));
  uint hashed = pcgHash(uint(y * width + x) + frame);
  uint latticeX = uint(x) * 2654435761u + uint(y) * 2246822519u + sampleIndex * 3266489917u +
                  seed * 668265263u;
  uint latticeY = uint(x) * 374761393u + uint(y) * 3266489917u + sampleIndex * 2654435761u +
                  seed * 2246822519u;
  return SampleKey(select(kNoiseSine, latticeX, hashed), latticeY, frame);
}

// The random number in [0, 1] (sine) or [0, 1) (pcg) of a decision within a sample.
float noise(SampleKey key, int bounce, int dimension) {
  uint counter = (uint(bounce) * uint(kCounterStride) + uint(dimension)) * 2654435769u;
  if (kNoiseSine) {
    precise float fromLattice =
        sineHash(unitFloat(key.first + counter), unitFloat(key.second + counter * 3u));
    return fromLattice;
  }
  // Two rounds: inputs of one round that differ by a multiple of a high power of two, as counters of
  // neighbouring bounces would, give correlated numbers.
  uint atBounce = pcgHash(key.first + uint(bounce) * 2654435769u);
  precise float hashed = unitFloat(pcgHash(atBounce + uint(dimension) * 2246822519u));
  return hashed;
}
