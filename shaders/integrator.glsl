// The chosen integrator, and the loop over the samples of one pixel.
#pragma once

#include "path.glsl"
#include "report.glsl"
#include "whitted.glsl"

PathState stepSample(PathState state, Frame frame) {
  if (kIntegrator == kIntegratorPath) {
    return stepPath(state, frame);
  }
  if (kIntegrator == kIntegratorReport) {
    return stepReport(state, frame);
  }
  if (kIntegrator == kIntegratorWhitted) {
    return stepWhitted(state, frame);
  }
  return stepLocal(state, frame);
}

// Sum of a frame's samples of one pixel, in sample order. A path that ends makes room at once for
// the pixel's next sample, so that neighbouring lanes don't wait for the longest path.
vec3 renderPixel(int x, int y, Frame frame) {
  precise vec3 sum = vec3(0.0f);
  int pass = 0;
  precise PathState state = beginSample(x, y, frame.firstSample, frame);
  while (pass < frame.passes) {
    state = stepSample(state, frame);
    if (!state.alive) {
      sum = sum + state.radiance;
      pass = pass + 1;
      state = beginSample(x, y, frame.firstSample + uint(pass), frame);
    }
  }
  return sum;
}
