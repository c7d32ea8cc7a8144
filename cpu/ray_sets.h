#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "common/scene/flat_scene.h"
#include "common/trace/ray_caster.h"

namespace twintrace {

/// Rays as a path tracer casts them: through the centres of the pixels; from what those meet to a light;
/// and from there into the hemisphere, by the cosine.
enum class RayKind { primary, shadow, diffuse };
inline constexpr std::array<std::string_view, 3> kRayKindNames = {"primary", "shadow", "diffuse"};

/// The scene's rays of a kind, one for each pixel of the film that has one, row by row. Shadow rays go to
/// the scene's lights, or without any to its emitting primitives, or else to a point far above; they end
/// there.
/// @param options seed, intersector and threads; noise decides as in a render
std::vector<CastRay> sceneRays(std::shared_ptr<const FlatScene> scene, const RenderOptions& options,
                               RayKind kind);

}  // namespace twintrace
