#pragma once

#include <string>

#include "common/scene/flat_scene.h"
#include "gpu/shader_source.h"

namespace twintrace {

/// Scenes with more primitives than this keep their geometry in the texel array.
inline constexpr int kMaxLiteralPrimitives = 64;

/// Whether the program gets the geometry as literals: asked for, or automatic and small enough.
/// @throws UsageError if literals were asked for and the scene has too many primitives, or the file
/// that they replace is overridden.
bool usesLiteralGeometry(const FlatScene& scene, const RenderOptions& options);

/// Whether counts and offsets are uniforms, so that one program serves every scene: with all effects
/// compiled in and the geometry in the texel array.
bool usesUniformIndex(const FlatScene& scene, const RenderOptions& options);

/// Names and values of the scene's counts and offsets as the shaders know them.
std::vector<std::pair<std::string, int>> indexConstants(const SceneIndex& index);

/// The shader files that the options name: a directory's or the binary's, and the user's own.
/// @throws UsageError for an override of a file that the library doesn't have.
ShaderLibrary shaderLibrary(const RenderOptions& options);

/// Which operations of strict maths the program corrects, since the device does not round them.
struct Corrections {
  bool division = false;
  bool root = false;
};

/// The constants that pick corrected operations, as every program with math.glsl needs them.
std::string correctionConstants(const Corrections& corrections);

/// The program that renders this scene under these options.
ShaderRequest specialise(const FlatScene& scene, const RenderOptions& options,
                         const Corrections& corrections = {});

}  // namespace twintrace
