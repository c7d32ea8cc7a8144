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
// - Embree's own plane distances, even in the fast form bound * inverse - origin * inverse, are off
// by
//   4 u D once its coordinates are relative to the scene's centre, which they are here; callbacks
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
#include "cpu/embree_device.h"
#include "cpu/kernel/geometry.h"

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

struct Bounds {
  glm::dvec3 low;
  glm::dvec3 high;
};

glm::dvec3 toDouble(const kernel::Vec3<float>& v) {
  return {v.x, v.y, v.z};
}

Bounds boundsOf(const kernel::Sphere<float>& sphere) {
  const glm::dvec3 center = toDouble(sphere.center);
  const glm::dvec3 radius(std::fabs(sphere.radius));
  return {center - radius, center + radius};
}

Bounds boundsOf(const kernel::Box<float>& box) {
  const glm::dvec3 a = toDouble(box.minimum);
  const glm::dvec3 b = toDouble(box.maximum);
  return {glm::min(a, b), glm::max(a, b)};
}

// The axes are orthonormal to u, which the padding covers.
Bounds boundsOf(const kernel::OrientedBox<float>& box) {
  const glm::dvec3 half = glm::abs(toDouble(box.halfSize));
  const glm::dvec3 extent = glm::abs(toDouble(box.axisX)) * half.x +
                            glm::abs(toDouble(box.axisY)) * half.y +
                            glm::abs(toDouble(box.axisZ)) * half.z;
  const glm::dvec3 center = toDouble(box.center);
  return {center - extent, center + extent};
}

Bounds boundsOf(const kernel::SceneView& scene, int primitive) {
  const int box = primitive - scene.index.sphereCount;
  if (box < 0) return boundsOf(kernel::fetchSphere<float>(scene, primitive));
  const int orientedBox = box - scene.index.boxCount;
  if (orientedBox < 0) return boundsOf(kernel::fetchBox<float>(scene, box));
  return boundsOf(kernel::fetchOrientedBox<float>(scene, orientedBox));
}

float intersectPrimitive(const kernel::SceneView& scene, const Ray& ray, int primitive) {
  const int box = primitive - scene.index.sphereCount;
  if (box < 0) return intersectSphere(scene, ray, kernel::fetchSphere<float>(scene, primitive));
  const int orientedBox = box - scene.index.boxCount;
  if (orientedBox < 0) return intersectBox(scene, ray, kernel::fetchBox<float>(scene, box));
  return intersectOrientedBox(scene, ray, kernel::fetchOrientedBox<float>(scene, orientedBox));
}

/// Primitives that the kernel tests and that have bounds.
std::vector<int> boundedPrimitives(const kernel::SceneView& scene) {
  std::vector<int> result;
  int first = 0;
  const auto add = [&](bool present, int count) {
    for (int i = 0; present && i < count; ++i) result.push_back(first + i);
    first += count;
  };
  add(scene.effectSphere, scene.index.sphereCount);
  add(scene.effectBox, scene.index.boxCount);
  add(scene.effectOrientedBox, scene.index.orientedBoxCount);
  return result;
}

kernel::SceneView planesOf(kernel::SceneView scene) {
  scene.effectSphere = false;
  scene.effectBox = false;
  scene.effectOrientedBox = false;
  return scene;
}

/// What Embree's context carries to the callback.
struct Query {
  EmbreeContext context;  // must be first
  const Ray* ray;
  Hit best;
};

class EmbreeHull : public HullQuery {
 public:
  EmbreeHull(const FlatScene& scene, const RenderOptions& options)
      : view_(kernel::viewScene(scene, options, nullptr)),
        planes_(planesOf(view_)),
        primitives_(boundedPrimitives(view_)) {
    measureScene();
    if (usable_) buildTree();
  }

  int closest(const float origin[3], const float direction[3], float tmin, float tmax,
              float& t) const override {
    const Ray ray = kernel::makeRay<float>({origin[0], origin[1], origin[2]},
                                           {direction[0], direction[1], direction[2]}, tmin, tmax);
    const Hit start{tmax, kernel::kNoPrimitive};
    const Hit hit = isTame(ray) ? searchTree(ray, visitGeometry(planes_, ray, start))
                                : visitGeometry(view_, ray, start);
    if (hit.primitive != kernel::kNoPrimitive) t = hit.t;
    return hit.primitive;
  }

 private:
  void measureScene() {
    Bounds all{glm::dvec3(kernel::kInfinity), glm::dvec3(-kernel::kInfinity)};
    for (const int primitive : primitives_) {
      const Bounds bounds = boundsOf(view_, primitive);
      all = {glm::min(all.low, bounds.low), glm::max(all.high, bounds.high)};
    }
    center_ = glm::vec3((all.low + all.high) * 0.5);
    const glm::dvec3 center(center_);
    const double radius = glm::length(glm::max(all.high - center, center - all.low));
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
    const Bounds bounds = boundsOf(hull.view_, hull.primitives_[call->primID]);
    const glm::dvec3 low = bounds.low - glm::dvec3(hull.center_) - hull.padding_;
    const glm::dvec3 high = bounds.high - glm::dvec3(hull.center_) + hull.padding_;
    const auto below = [](double x) { return std::nextafter(float(x), -kernel::kInfinity); };
    const auto above = [](double x) { return std::nextafter(float(x), kernel::kInfinity); };
    *call->bounds_o = {below(low.x),  below(low.y),  below(low.z),  0.0f,
                       above(high.x), above(high.y), above(high.z), 0.0f};
  }

  // Queries are single rays: N is 1. The best hit lives in the query; Embree needs only its t.
  static void testPrimitive(const RTCIntersectFunctionNArguments* call) {
    const auto& hull = *static_cast<const EmbreeHull*>(call->geometryUserPtr);
    Query& query = *reinterpret_cast<Query*>(call->context);
    const int primitive = hull.primitives_[call->primID];
    const float t = intersectPrimitive(hull.view_, *query.ray, primitive);
    query.best = kernel::nearer(query.best, t, primitive);
    auto& search = *reinterpret_cast<RTCRayHit*>(call->rayhit);
    search.ray.tfar = withoutNegativeZero(query.best.t);
  }

  kernel::SceneView view_;
  kernel::SceneView planes_;
  std::vector<int> primitives_;
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
