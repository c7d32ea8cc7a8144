// Embree's tree with our primitive tests, and why it never changes a hit.
//
// The tree may skip a primitive only if its float test misses or its t is beyond the best one. So a
// hull must be entered no later than the t that the test computes, however wrong that t is. With
// u = 2^-24 and D the largest distance between a ray's origin and a point of the scene:
// - Slabs (robust): planes are off by 3 u D, the widening lets rays pass that miss by 12 u D; an
//   oriented box adds 8 u D for its local ray.
// - Sphere (robust): the discriminant is the exact one of a radius off by at most 12 u D. The near
//   root c / q carries an error e / q with |e| <= 4 u |f|^2 + 20 u r |f|, f from centre to origin.
//   For |f| >= 2 r this is 17 u D; nearer, the point at the computed t is less than 56 u r +
//   (e/q)^2 / 2r above the surface, together 106 u r unless q < 5.6 sqrt(u) r, and then the origin
//   itself is within 16 u r of the surface, hence in the hull, which is entered at 0.
// - Triangles (robust): the vertices relative to the origin are rounded, 1 u D, as are their two
//   coordinates beside the ray, 2 u D more; edge functions and t are in double: below 8 u D.
// - Embree's own plane distances, even in the fast form bound * inverse - origin * inverse, are off
//   by 4 u D once its coordinates are relative to the scene's centre, which they are here; callbacks
//   get the ray as it was.
// All this stays below 128 u D. Hulls are padded by that, so that entries lie strictly before t and
// primitives with equal t are all tested. The report's tests round absolute coordinates, so that
// there D includes them, and are geometry only for unit directions.
// Underflow and overflow, Embree's limits (coordinates 1.8e18, direction components 1e-18, no
// negative t) and origins far outside stay out of the tree: isTame.

#include "cpu/embree_hull.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "common/base/error.h"
#include "common/hulls/convex_shape.h"
#include "common/hulls/hull_structure.h"
#include "cpu/embree_device.h"
#include "cpu/kernel/geometry.h"
#include "cpu/kernel/primitive.h"

namespace twintrace {
namespace {

using Ray = kernel::Ray<float>;
using Hit = kernel::Hit<float>;

constexpr double kPadding = 128.0 / (1 << 24);
/// Origins up to this many scene radii from the scene's centre, per coordinate, use the tree.
constexpr double kReach = 16.0;
/// Radii of scenes that get a tree: D^2 and a direction's square stay within floats.
constexpr double kSmallestRadius = 1.0 / (1 << 24);
constexpr double kLargestRadius = double(std::int64_t{1} << 34);
/// Largest component of directions that use the tree.
constexpr float kShortestDirection = 1.0f / (1 << 20);
constexpr float kLongestDirection = 1 << 20;
/// How far d.d of a normalised direction may be from 1: a few u, and the report's error grows by as
/// much times D.
constexpr float kUnitSlack = 8.0f / (1 << 24);

/// What Embree's context carries to the callback.
struct Query {
  EmbreeContext context;  // must be first
  const Ray* ray;
  Hit best;
};

class EmbreeHull : public HullQuery {
 public:
  EmbreeHull(const FlatScene& scene, const RenderOptions& options)
      : scene_(scene),
        view_(kernel::viewScene(scene, options, nullptr)),
        primitives_(boundedPrimitives(scene)) {
    measureScene();
    if (usable_) buildTree();
  }

  int closest(const HullQueryRay<float>& query, float& t) const override {
    const Ray ray = kernel::makeRay<float>(
        {query.origin[0], query.origin[1], query.origin[2]},
        {query.direction[0], query.direction[1], query.direction[2]}, query.tmin, query.tmax);
    const Hit start{query.tmax, kernel::kNoPrimitive};
    const Hit hit = isTame(ray) ? searchTree(ray, visitPlanes(view_, ray, start))
                                : visitGeometry(view_, ray, start);
    if (hit.primitive != kernel::kNoPrimitive) t = hit.t;
    return hit.primitive;
  }

 private:
  void measureScene() {
    Bounds all = Bounds::nothing();
    for (const std::uint32_t primitive : primitives_) {
      all.add(boundsOf(convexShape(scene_, static_cast<int>(primitive))));
    }
    center_ = all.center();
    const glm::dvec3 center(center_);
    const double radius = glm::length(glm::max(glm::dvec3(all.high) - center, center - glm::dvec3(all.low)));
    usable_ = radius >= kSmallestRadius && radius <= kLargestRadius &&
              glm::length(center) <= kLargestRadius;
    reach_ = static_cast<float>(kReach * radius);
    const double distance = (std::sqrt(3.0) * kReach + 1.0) * radius;
    const double absolute = view_.intersectorReport ? glm::length(center) : 0.0;
    padding_ = kPadding * (distance + absolute);
  }

  void buildTree() {
    device_ = openEmbreeDevice();
    tree_ = makeEmbreeScene(device_);
    const EmbreeGeometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(primitives_.size()));
    rtcSetGeometryUserData(geometry.get(), this);
    rtcSetGeometryBoundsFunction(geometry.get(), writeBounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), testPrimitive);
    attachEmbreeGeometry(tree_, geometry, 0);
    commitEmbreeScene(device_, tree_);
  }

  /// Whether the padding covers all rounding of this ray. Written so that a NaN fails.
  bool isTame(const Ray& ray) const {
    if (!usable_) return false;
    const auto largest = [](const kernel::Vec3<float>& v) {
      return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    };
    const kernel::Vec3<float>& d = ray.direction;
    const kernel::Vec3<float> offset = ray.origin - kernel::toVec3(center_);
    const float squared = kernel::dot3(d, d);
    const bool finite = std::isfinite(squared) && std::isfinite(kernel::dot3(offset, offset)) &&
                        std::isfinite(ray.tmax);
    const bool scaled = largest(d) >= kShortestDirection && largest(d) <= kLongestDirection;
    const bool meant = !view_.intersectorReport || std::fabs(squared - 1.0f) <= kUnitSlack;
    return finite && scaled && meant && largest(offset) <= reach_ && ray.tmin >= 0.0f;
  }

  Hit searchTree(const Ray& ray, const Hit& start) const {
    Query query{makeEmbreeContext(), &ray, start};
    const glm::vec3 origin(ray.origin.x, ray.origin.y, ray.origin.z);
    const glm::vec3 direction(ray.direction.x, ray.direction.y, ray.direction.z);
    // Not tmin: a t that was computed too large may lie behind the hull.
    RTCRayHit search = makeEmbreeQuery(origin - center_, direction, 0.0f, start.t);
    intersectEmbree(tree_, query.context, search);
    return query.best;
  }

  static void writeBounds(const RTCBoundsFunctionArguments* call) {
    const auto& hull = *static_cast<const EmbreeHull*>(call->geometryUserPtr);
    const Bounds bounds = boundsOf(convexShape(hull.scene_, static_cast<int>(hull.primitives_[call->primID])));
    const glm::dvec3 center(hull.center_);
    const glm::dvec3 low = glm::dvec3(bounds.low) - center - hull.padding_;
    const glm::dvec3 high = glm::dvec3(bounds.high) - center + hull.padding_;
    *call->bounds_o = {roundedDown(low.x), roundedDown(low.y), roundedDown(low.z), 0.0f,
                       roundedUp(high.x),  roundedUp(high.y),  roundedUp(high.z),  0.0f};
  }

  // Queries are single rays: N is 1. The best hit lives in the query; Embree needs only its t.
  static void testPrimitive(const RTCIntersectFunctionNArguments* call) {
    const auto& hull = *static_cast<const EmbreeHull*>(call->geometryUserPtr);
    Query& query = *reinterpret_cast<Query*>(call->context);
    const auto primitive = static_cast<int>(hull.primitives_[call->primID]);
    const float t = intersectPrimitive(hull.view_, *query.ray, primitive);
    query.best = kernel::nearer(query.best, t, primitive);
    auto& search = *reinterpret_cast<RTCRayHit*>(call->rayhit);
    search.ray.tfar = withoutNegativeZero(query.best.t);
  }

  const FlatScene& scene_;
  kernel::SceneView view_;
  std::vector<std::uint32_t> primitives_;
  glm::vec3 center_{0.0f};
  float reach_ = 0.0f;
  double padding_ = 0.0;
  bool usable_ = false;
  EmbreeDevice device_;
  EmbreeScene tree_;
};

}  // namespace

std::unique_ptr<HullQuery> makeEmbreeHull(const FlatScene& scene, const RenderOptions& options) {
  if (options.precision == Precision::float64) {
    throw UsageError(
        "hull embree with precision double; expected precision float, since Embree's "
        "rays are floats");
  }
  return std::make_unique<EmbreeHull>(scene, options);
}

}  // namespace twintrace
