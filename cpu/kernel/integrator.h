#pragma once

// Twin of shaders/integrator.glsl: the chosen integrator, and the loop over the samples of a pixel.

#include "cpu/kernel/path.h"
#include "cpu/kernel/report.h"
#include "cpu/kernel/whitted.h"

TWINTRACE_KERNEL_BEGIN

/// Calls `use` with the step function of an integrator: one instantiation for each, so that loops
/// around the step are specialised too.
template <class R, class Use>
auto withStep(Integrator integrator, Use use) {
  switch (integrator) {
    case Integrator::path:
      return use([](const auto&... a) { return stepPath<R>(a...); });
    case Integrator::report:
      return use([](const auto&... a) { return stepReport<R>(a...); });
    case Integrator::whitted:
      return use([](const auto&... a) { return stepWhitted<R>(a...); });
    case Integrator::local:
      break;
  }
  return use([](const auto&... a) { return stepLocal<R>(a...); });
}

template <class R>
PathState<R> stepSample(const SceneView& scene, const PathState<R>& state, const Frame& frame) {
  return withStep<R>(scene.integrator,
                     [&](auto step) { return step(scene, state, frame); });
}

/// The loop over the samples of a pixel, with one integrator's step inlined.
template <class R, class Step>
TWINTRACE_STEP Vec3<R> sumSamples(const SceneView& scene, int x, int y, const Frame& frame,
                                  Step step) {
  Vec3<R> sum;
  for (int pass = 0; pass < frame.passes; ++pass) {
    PathState<R> state =
        beginSample<R>(scene, x, y, frame.firstSample + static_cast<std::uint32_t>(pass), frame);
    while (state.alive) state = step(scene, state, frame);
    sum = sum + state.radiance;
  }
  return sum;
}

/// Sum of a frame's samples of one pixel, in sample order; for one-lane numbers.
template <class R>
Vec3<R> renderPixel(const SceneView& scene, int x, int y, const Frame& frame) {
  return withStep<R>(scene.integrator,
                     [&](auto step) { return sumSamples<R>(scene, x, y, frame, step); });
}

TWINTRACE_KERNEL_END
