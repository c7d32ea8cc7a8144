#pragma once

#include <string>

#include "common/scene/flat_scene.h"
#include "gpu/shader_source.h"

namespace twintrace {

/// Scenes with more primitives than this keep their geometry in the texel array.
inline constexpr int kMaxLiteralPrimitives = 64;

/// The file that says how primitives are visited, replaced for scenes with hulls.
inline constexpr const char* kWalkFile = "hulls/chosen_walk.glsl";
/// The function of that file.
inline constexpr const char* kWalkFunction = "visitScene";

/// Whether the program gets the geometry as literals: asked for, or automatic and small enough.
/// @throws UsageError if literals were asked for and the scene has too many primitives, or the file
/// that they replace is overridden.
bool usesLiteralGeometry(const FlatScene& scene, const RenderOptions& options);

/// Whether counts and offsets are uniforms, so that one program serves every scene: with all effects
/// compiled in and the geometry in the texel array.
bool usesUniformIndex(const FlatScene& scene, const RenderOptions& options);

/// Names and values of the scene's counts and offsets as the shaders know them.
std::vector<std::pair<std::string, int>> indexConstants(const FlatScene& scene);

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

/// @throws UsageError for options that only the C++ tracer has.
void refuseCpuOptions(const RenderOptions& options);

/// The program that renders this scene under these options.
/// @param countHulls whether walks through hulls count what they do
ShaderRequest specialise(const FlatScene& scene, const RenderOptions& options,
                         const Corrections& corrections = {}, bool countHulls = false);

}  // namespace twintrace
