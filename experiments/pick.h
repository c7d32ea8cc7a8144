#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/film/image.h"
#include "common/scene/flat_scene.h"
#include "common/scene/scene.h"

namespace twintrace {

/// What a pixel's centre shows.
struct Picked {
  std::string object;
  std::string material;
  int primitive = -1;
  float t = 0;  ///< distance from the lens centre
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};
};

/// Casts the ray through lens centre and pixel centre with the CPU kernel.
/// @return nothing if the ray leaves the scene.
/// @throws UsageError for a pixel outside the film.
std::optional<Picked> pickPixel(const Scene& scene, std::shared_ptr<const FlatScene> flat,
                                const RenderOptions& options, const PixelPosition& pixel);

}  // namespace twintrace
