#pragma once

#include <memory>
#include <string>

#include "common/film/film.h"
#include "common/scene/flat_scene.h"
#include "common/scene/scene.h"
#include "common/trace/renderer.h"

namespace twintrace {

/// A scene under options, ready to render: all of `render`, one side of `compare`.
struct Arm {
  RenderOptions options;
  std::shared_ptr<const FlatScene> scene;
  FilmMetadata metadata;  ///< of the films that it renders; with the driver where it matters
  std::unique_ptr<Renderer> renderer;
};

/// Flattens a scene under options.
/// @throws FileError also for files named by the scene that can't be read; UsageError for options
/// that exclude each other.
std::shared_ptr<const FlatScene> flattenScene(const Scene& scene, const RenderOptions& options);

/// What determines the bits of a film, save its samples. Strict maths in float gives equal bits on
/// every back end, so back end, lanes, stage and hull are not part of it; native maths and double
/// precision name what computed them, and shaders from a directory or of the user's are named by their hash. Effects
/// count only where the scene needs them: branches compiled in for nothing change no bit.
FilmMetadata filmMetadata(const Scene& scene, const FlatScene& flat, const RenderOptions& options);

/// Flattens the scene and opens the back end that the options name.
/// @throws as flattenScene; UsageError for a film beyond the machine's memory; DeviceError if the
/// back end is missing.
Arm openArm(const Scene& scene, const RenderOptions& options);

}  // namespace twintrace
