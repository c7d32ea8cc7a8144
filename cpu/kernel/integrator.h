#pragma once

// Twin of shaders/integrator.glsl: the chosen integrator, and the loop over the samples of a pixel.

#include "cpu/kernel/path.h"
#include "cpu/kernel/report.h"
#include "cpu/kernel/whitted.h"

TWINTRACE_KERNEL_BEGIN

template <class R>
PathState<R> stepSample(const SceneView& scene, const PathState<R>& state, const Frame& frame) {
  switch (scene.integrator) {
    case Integrator::path:
      return stepPath(scene, state, frame);
    case Integrator::report:
      return stepReport(scene, state, frame);
    case Integrator::whitted:
      return stepWhitted(scene, state, frame);
    case Integrator::local:
      break;
  }
  return stepLocal(scene, state, frame);
}

/// Sum of a frame's samples of one pixel, in sample order; for one-lane numbers.
template <class R>
Vec3<R> renderPixel(const SceneView& scene, int x, int y, const Frame& frame) {
  Vec3<R> sum;
  for (int pass = 0; pass < frame.passes; ++pass) {
    PathState<R> state =
        beginSample<R>(scene, x, y, frame.firstSample + static_cast<std::uint32_t>(pass), frame);
    while (state.alive) state = stepSample(scene, state, frame);
    sum = sum + state.radiance;
  }
  return sum;
}

TWINTRACE_KERNEL_END
