#include "experiments/pick.h"

#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>

#include "common/base/error.h"
#include "cpu/kernel_caster.h"

namespace twintrace {
namespace {

void checkPixel(const FlatScene& flat, const PixelPosition& pixel) {
  if (pixel.x >= 0 && pixel.y >= 0 && pixel.x < flat.width && pixel.y < flat.height) return;
  throw UsageError(fmt::format("pixel: found {},{}, expected x from 0 to {} and y from 0 to {}",
                               pixel.x, pixel.y, flat.width - 1, flat.height - 1));
}

CastRay centreRay(const FlatCamera& camera, const PixelPosition& pixel) {
  const glm::vec3 direction = camera.corner + (float(pixel.x) + 0.5f) * camera.stepX +
                              (float(pixel.y) + 0.5f) * camera.stepY;
  CastRay ray;
  ray.origin = camera.origin;
  ray.direction = glm::normalize(direction);
  return ray;
}

}  // namespace

std::optional<Picked> pickPixel(const Scene& scene, std::shared_ptr<const FlatScene> flat,
                                const RenderOptions& options, const PixelPosition& pixel) {
  checkPixel(*flat, pixel);
  const std::array rays = {centreRay(flat->camera, pixel)};
  const CastHit hit = makeKernelCaster(flat, options)->cast(rays).front();
  if (!hit.valid()) return std::nullopt;
  const auto object =
      static_cast<std::size_t>(flat->primitiveObject[static_cast<std::size_t>(hit.primitive)]);
  const auto material = static_cast<std::size_t>(scene.objects[object].material);
  return Picked{flat->objectNames[object],
                scene.materials[material].name,
                hit.primitive,
                hit.t,
                rays[0].origin + hit.t * rays[0].direction,
                hit.normal};
}

}  // namespace twintrace
