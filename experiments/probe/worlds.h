#pragma once

#include <string>
#include <vector>

#include "common/scene/flat_scene.h"
#include "cpu/kernel/scene_view.h"
#include "experiments/probe/shader_function.h"

namespace twintrace::probe {

/// Primitives of cases, of all kinds, that every world's texels end with.
inline constexpr int kWorldCases = 18;

/// A small scene under one set of options, for functions that read scene data or constants. Movable
/// only: the view points into the scene.
struct World {
  World() = default;
  World(World&&) = default;
  World& operator=(World&&) = default;

  std::string name;
  RenderOptions options;
  FlatScene scene;
  kernel::SceneView view;
};

/// The worlds whose differences the function can show, the plain one first.
std::vector<World> worldsFor(const ShaderFunction& function);

/// A user's scene under the options with which it was flattened; geometry in the texel array.
World sceneWorld(const FlatScene& scene, const RenderOptions& options);

/// The plain world: robust intersections, pcg noise, path integrator, geometry in the texel array.
World plainWorld();

}  // namespace twintrace::probe
