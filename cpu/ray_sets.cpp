#include "cpu/ray_sets.h"

#include <tbb/blocked_range.h>

#include <glm/geometric.hpp>
#include <optional>

#include "common/base/flush_denormals.h"
#include "common/base/parallel_for.h"
#include "common/hulls/convex_shape.h"
#include "cpu/hull_walk.h"
#include "cpu/kernel/light.h"
#include "cpu/kernel/vertex.h"
#include "cpu/kernel_vectors.h"
#include "cpu/thread_arena.h"

namespace twintrace {
namespace {

using Ray = kernel::Ray<float>;
using Vector = kernel::Vec3<float>;

CastRay castRay(const Ray& ray) {
  return {toFloats(ray.origin), toFloats(ray.direction), ray.tmin, ray.tmax};
}

/// Center of all that has bounds, and half the length of the box's diagonal.
struct Extent {
  glm::vec3 center{0.0f};
  float radius = 1.0f;
};

Extent extentOf(const FlatScene& scene) {
  Bounds all = Bounds::nothing();
  for (int i = 0; i < scene.index.boundedCount(); ++i) all.add(boundsOf(convexShape(scene, i)));
  if (scene.index.boundedCount() == 0) return {};
  return {all.center(), glm::length(all.high * 0.5f - all.low * 0.5f)};
}

/// Points that shadow rays go to in scenes without local lights.
std::vector<Vector> shadowTargets(const FlatScene& scene, const kernel::SceneView& view) {
  std::vector<Vector> targets;
  for (int i = 0; i < scene.index.boundedCount(); ++i) {
    const Vector emission = kernel::fetchPrimitiveInfo<float>(view, i).emission;
    if (kernel::isBlack(emission)) continue;
    targets.push_back(toKernel<float>(boundsOf(convexShape(scene, i)).center()));
  }
  if (!targets.empty()) return targets;
  const Extent extent = extentOf(scene);
  targets.push_back(toKernel<float>(extent.center + glm::vec3(1.0f, 3.0f, 2.0f) * extent.radius));
  return targets;
}

class SceneRays {
 public:
  SceneRays(const FlatScene& scene, const RenderOptions& options)
      : query_(makeHullQuery(scene, options)),
        view_(kernel::viewScene(scene, options, query_.get())),
        frame_{scene.width, options.bounces, 1, static_cast<std::uint32_t>(options.firstSample),
               options.seed},
        targets_(shadowTargets(scene, view_)) {}

  std::optional<CastRay> ray(RayKind kind, int x, int y) const {
    auto state = kernel::beginSample<float>(view_, x, y, frame_.firstSample, frame_);
    state.ray = centralRay(x, y);
    if (kind == RayKind::primary) return castRay(state.ray);
    const kernel::Vertex<float> vertex = arrive(view_, state, frame_);
    if (!vertex.scatters) return std::nullopt;
    const float u = kernel::noise<float>(view_, state.key, 0, kernel::kDimensionDirectionU);
    const float v = kernel::noise<float>(view_, state.key, 0, kernel::kDimensionDirectionV);
    return castRay(kind == RayKind::diffuse ? diffuseRay(vertex, u, v)
                                            : shadowRay(vertex, y * frame_.width + x, u, v));
  }

 private:
  /// Through the centre of the pixel, and of the lens.
  Ray centralRay(int x, int y) const {
    const kernel::Camera<float> camera = kernel::fetchCamera<float>(view_);
    const Vector target = (camera.corner + camera.stepX * (static_cast<float>(x) + 0.5f)) +
                          camera.stepY * (static_cast<float>(y) + 0.5f);
    return kernel::makeRay(camera.origin, kernel::normalize3(target), 0.0f, kernel::kLargest);
  }

  static Ray diffuseRay(const kernel::Vertex<float>& vertex, float u, float v) {
    const Vector direction =
        kernel::tangentToWorld(vertex.normal, kernel::sampleCosineHemisphere(u, v));
    return kernel::makeRay(vertex.origin, direction, 0.0f, kernel::kLargest);
  }

  Ray shadowRay(const kernel::Vertex<float>& vertex, int pixel, float u, float v) const {
    if (view_.index.lightCount > 0) {
      const auto light = kernel::fetchLight<float>(view_, pixel % view_.index.lightCount);
      const auto sample = kernel::sampleLight(view_, light, vertex.origin, u, v);
      return kernel::makeRay(vertex.origin, sample.direction, 0.0f, sample.distance);
    }
    const Vector towards =
        targets_[static_cast<std::size_t>(pixel) % targets_.size()] - vertex.origin;
    const float distance = kernel::length3(towards);
    return kernel::makeRay(vertex.origin, kernel::divide(towards, distance), 0.0f,
                           kernel::shadowReach(distance));
  }

  std::unique_ptr<HullQuery> query_;
  kernel::SceneView view_;
  kernel::Frame frame_;
  std::vector<Vector> targets_;
};

}  // namespace

std::vector<CastRay> sceneRays(std::shared_ptr<const FlatScene> scene, const RenderOptions& options,
                               RayKind kind) {
  const SceneRays source(*scene, options);
  const auto width = static_cast<std::size_t>(scene->width);
  std::vector<std::optional<CastRay>> drawn(width * static_cast<std::size_t>(scene->height));
  ThreadArena arena(options.threads);
  arena.execute([&] {
    parallelFor(tbb::blocked_range<std::size_t>(0, drawn.size()), [&](const auto& part) {
      const FlushDenormals flush;
      for (std::size_t i = part.begin(); i < part.end(); ++i) {
        drawn[i] = source.ray(kind, static_cast<int>(i % width), static_cast<int>(i / width));
      }
    });
  });
  std::vector<CastRay> rays;
  for (const std::optional<CastRay>& ray : drawn) {
    if (ray) rays.push_back(*ray);
  }
  return rays;
}

}  // namespace twintrace
