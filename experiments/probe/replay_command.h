#pragma once

#include <array>
#include <string>

#include "common/scene/scene.h"
#include "experiments/explain/explanation.h"

namespace twintrace::probe {

/// The options of rendering that decide what a function reads of a scene, and how the shader is
/// specialised for it.
inline constexpr std::array kSceneOptions = {"integrator", "noise", "intersector", "effects",
                                             "bounces",    "width", "height"};

/// The command that runs a located call alone, ready for a shell: the function with the words of
/// its inputs, the scene, and what the shader's arm has other than the scene asks for.
///
/// `probe` runs the shader against the float twin, so there is none without a GPU arm or a located
/// call; of two GPU arms it takes b.
/// @return empty if there is none.
std::string replayCommand(const Scene& scene, const RenderOptions& a, const RenderOptions& b,
                          const SampleExplanation& explanation);

}  // namespace twintrace::probe
